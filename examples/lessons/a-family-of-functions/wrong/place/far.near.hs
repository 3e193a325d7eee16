speed :: Double -> Double -> Position -> Velocity
speed a b (Position x _) = Velocity (a * (b - x)) 0

main = simulate (speed 0.8 1.5)
