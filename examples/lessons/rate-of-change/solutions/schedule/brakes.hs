speed :: Position -> Velocity
speed (Position x _)
  | x < 1 = Velocity 0.25 0
  | x < 1.9 = Velocity 0.52 0
  | otherwise = Velocity (2 * (2 - x)) 0

main = simulate speed
