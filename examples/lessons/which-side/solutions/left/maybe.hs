tour :: Seconds -> Velocity
tour now
  | now < 4 = Velocity 0.3 0
  | now < 5 = Velocity (-0.3) 0
  | now < 9 = Velocity 0 0.785
  | now < 13 = Velocity 0.3 0
  | otherwise = Velocity 0 0

light :: Bumper -> Maybe Led1
light (Bumper LeftBumper Pressed) = Just (Led1 Orange)
light _ = Nothing

main = simulate (tour, light)
