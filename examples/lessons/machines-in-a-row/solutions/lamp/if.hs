distance :: Position -> Double
distance (Position x _) = 1 - x

speed :: Double -> Velocity
speed d = Velocity (0.6 * d) 0

light :: Double -> Led1
light d = Led1 (if d < 0.5 then Red else Green)

go :: Position -> Velocity
go = speed . distance

main = simulate (go, light . distance)
