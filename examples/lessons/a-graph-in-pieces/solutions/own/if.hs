speed :: Position -> Velocity
speed (Position x _) = Velocity (if x < 1 then 0.2 + 0.4 * x else 1.2 - 0.6 * x) 0

main = simulate speed
