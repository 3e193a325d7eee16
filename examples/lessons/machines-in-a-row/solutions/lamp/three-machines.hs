distance :: Position -> Double
distance (Position x _) = 1 - x

speed :: Double -> Velocity
speed d = Velocity (0.6 * d) 0

isNear :: Double -> Bool
isNear d = d < 0.5

light :: Bool -> Led1
light near = if near then Led1 Red else Led1 Green

go :: Position -> Velocity
go = speed . distance

main = simulate (go, light . isNear . distance)
