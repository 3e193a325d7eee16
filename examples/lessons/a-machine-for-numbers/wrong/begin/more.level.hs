speed :: Position -> Velocity
speed (Position x _) = Velocity (0.4) 0

main = simulate speed
