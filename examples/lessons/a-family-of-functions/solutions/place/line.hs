speed :: Double -> Double -> Position -> Velocity
speed start slope (Position x _) = Velocity (start - slope * x) 0

main = simulate (speed 1.5 0.6)
