speed :: Position -> Velocity
speed (Position x _)
  | x < 1.95 = Velocity 0.2 0
  | otherwise = Velocity 0 0

main = simulate speed
