speed :: Double -> Double -> Position -> Velocity
speed a b (Position x _)
  | x < b = Velocity a 0
  | otherwise = Velocity 0 0

main = simulate (speed 0.3 2.5)
