speed :: Position -> Velocity
speed (Position x _) = Velocity (0.5 - 0.5 * x) 0

main = simulate speed
