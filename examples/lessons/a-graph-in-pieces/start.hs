speed :: Position -> Velocity
speed (Position x _)
  | x < 1 = Velocity 0.2 0
  | x < 2 = Velocity 0.5 0
  | otherwise = Velocity 0 0

main = simulate speed
