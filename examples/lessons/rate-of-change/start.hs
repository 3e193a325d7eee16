speed :: Position -> Velocity
speed (Position x _)
  | x < 0.6 = Velocity 0.2 0
  | x < 1.8 = Velocity 0.4 0
  | otherwise = Velocity 0 0

main = simulate speed
