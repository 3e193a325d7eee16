speed :: Double -> Position -> Velocity
speed a (Position x _) = Velocity (a * (1.5 - x)) 0

main = simulate (speed 1)
