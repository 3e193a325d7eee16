speed :: Position -> Velocity
speed (Position x _) = Velocity (0.5 * (1 - x * x)) 0

main = simulate speed
