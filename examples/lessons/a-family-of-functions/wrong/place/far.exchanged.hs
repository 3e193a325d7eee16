speed :: Double -> Double -> Position -> Velocity
speed a b (Position x _) = Velocity (a * (b - x)) 0

main = simulate (speed 2.5 0.8)
