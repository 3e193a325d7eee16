speed :: Position -> Velocity
speed (Position x _)
  | x < 2 = Velocity 0.25 0
  | otherwise = Velocity 0 0

main = simulate speed
