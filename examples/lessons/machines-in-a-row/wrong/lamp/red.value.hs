distance :: Position -> Double
distance (Position x _) = 1 - x

speed :: Double -> Velocity
speed d = Velocity (0.6 * d) 0

light :: Led1
light = Led1 Green

go :: Position -> Velocity
go = speed . distance

main = simulate (go, light)
