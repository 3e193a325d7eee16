speed :: Position -> Velocity
speed (Position x _) = Velocity (if x < 1 then 0.25 else if x < 2 then 0.5 else 0) 0

main = simulate speed
