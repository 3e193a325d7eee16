distance :: Position -> Double
distance (Position x _) = 1 - x

speed :: Double -> Velocity
speed d = Velocity (0.6 * d) 0

light :: Double -> Led1
light d
  | d > 0.5 = Led1 Red
  | otherwise = Led1 Green

go :: Position -> Velocity
go = speed . distance

shine :: Position -> Led1
shine = light . distance

main = simulate (go, shine)
