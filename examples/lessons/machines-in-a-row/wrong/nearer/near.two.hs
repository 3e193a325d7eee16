distance :: Position -> Double
distance (Position x _) = 2 - x

speed :: Double -> Velocity
speed d = Velocity (0.6 * d) 0

go :: Position -> Velocity
go = speed . distance

main = simulate go
