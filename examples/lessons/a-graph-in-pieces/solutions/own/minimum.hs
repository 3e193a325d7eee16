speed :: Position -> Velocity
speed (Position x _) = Velocity (min (0.2 + 0.5 * x) (0.6 * (2 - x))) 0

main = simulate speed
