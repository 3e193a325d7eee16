speed :: Position -> Velocity
speed (Position x _) = Velocity (0.6 - 0.8 * x) 0

main = simulate speed
