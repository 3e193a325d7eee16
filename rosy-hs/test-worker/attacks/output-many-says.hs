main = simulate [Say (show n) | n <- [1 .. 1000000 :: Int]]
