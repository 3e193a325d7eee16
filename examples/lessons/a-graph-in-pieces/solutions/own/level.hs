speed :: Position -> Velocity
speed (Position x _)
  | x < 0.5 = Velocity 0.2 0
  | x < 1.9 = Velocity 0.5 0
  | otherwise = Velocity 0 0

main = simulate speed
