main = simulate grow

grow :: Velocity -> Say
grow _ = Say (show (length (show (2 ^ (2 ^ (31 :: Int) :: Int) :: Integer))))
