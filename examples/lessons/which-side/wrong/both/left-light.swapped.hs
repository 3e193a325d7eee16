tour :: Seconds -> Velocity
tour now
  | now < 4 = Velocity 0.3 0
  | now < 5 = Velocity (-0.3) 0
  | now < 9 = Velocity 0 0.785
  | now < 13 = Velocity 0.3 0
  | otherwise = Velocity 0 0

light :: Bumper -> Either Led1 Led2
light (Bumper LeftBumper Pressed) = Right (Led2 Orange)
light (Bumper RightBumper Pressed) = Left (Led1 Orange)
light _ = Left (Led1 Black)

main = simulate (tour, light)
