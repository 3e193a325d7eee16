distance :: Position -> Double
distance (Position x _) = 1 - x

speed :: Double -> Velocity
speed d = Velocity (0.7 * d) 0

go :: Position -> Velocity
go = speed . distance

main = simulate go
