main = simulate eat

eat :: Velocity -> Velocity
eat (Velocity v w) = Velocity (fromIntegral (length xs + last xs) + v) w
  where
    xs = [1 .. 6000000 :: Int]
