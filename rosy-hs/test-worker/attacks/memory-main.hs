main = print (length xs + last xs) >> simulate (Velocity 0 0)
  where
    xs = [1 .. 6000000 :: Int]
