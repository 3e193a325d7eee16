speed :: Position -> Velocity
speed (Position x _)
  | x < 0.3 = Velocity 0.3 0
  | otherwise = Velocity 0.1 0

main = simulate speed
