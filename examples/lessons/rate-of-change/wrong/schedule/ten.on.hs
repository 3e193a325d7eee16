speed :: Position -> Velocity
speed (Position x _)
  | x < 1 = Velocity 0.25 0
  | otherwise = Velocity 0.5 0

main = simulate speed
