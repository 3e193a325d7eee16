main = simulate (Say (show (fromRational (2 ^ (10 ^ 9 :: Int)) :: Double)))
