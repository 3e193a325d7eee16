speed :: Double -> Position -> Velocity
speed b (Position x _) = Velocity (0.5 * (b - x)) 0

main = simulate (speed 2.5)
