speed :: Seconds -> Velocity
speed t
  | t < 4 = Velocity 0.25 0
  | t < 6 = Velocity 0.5 0
  | otherwise = Velocity 0 0

main = simulate speed
