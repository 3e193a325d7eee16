distance :: Position -> Double
distance (Position x _) = 1 - x

speed :: Double -> Velocity
speed d = Velocity (0.6 * d) 0

shine :: Position -> Led1
shine (Position x _)
  | x > 0.5 = Led1 Red
  | otherwise = Led1 Green

go :: Position -> Velocity
go = speed . distance

main = simulate (go, shine)
