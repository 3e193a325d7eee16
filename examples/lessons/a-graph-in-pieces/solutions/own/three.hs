speed :: Position -> Velocity
speed (Position x _)
  | x < 1 = Velocity (0.2 + 0.3 * x) 0
  | x < 1.5 = Velocity 0.5 0
  | otherwise = Velocity (2 - x) 0

main = simulate speed
