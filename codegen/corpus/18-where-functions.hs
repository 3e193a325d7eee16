control :: Velocity -> Position -> Velocity
control (Velocity l a) (Position x y) = Velocity (clamp 0 0.7 l') (clamp (-1) 1 a')
  where
    l' = l + gain * err x
    a' = a + gain * err y
    gain = 0.1
    err v = 1 - v
    clamp lo hi v
      | v < lo = lo
      | v > hi = hi
      | otherwise = v

main :: IO ()
main = simulate control
