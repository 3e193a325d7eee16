speed :: Position -> Velocity
speed (Position x _)
  | x < 1 = Velocity (0.2 + 0.4 * x) 0
  | otherwise = Velocity (0.6 * (2 - x)) 0

main = simulate speed
