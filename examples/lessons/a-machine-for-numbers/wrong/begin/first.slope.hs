speed :: Position -> Velocity
speed (Position x _) = Velocity (0.2 + 0.9 * x) 0

main = simulate speed
