speed :: Position -> Velocity
speed (Position x _)
  | x > -1 = Velocity (-0.3) 0
  | otherwise = Velocity 0 0

main = simulate speed
