tour :: Seconds -> Velocity
tour now
  | now < 4 = Velocity 0.3 0
  | now < 5 = Velocity (-0.3) 0
  | now < 9 = Velocity 0 0.785
  | now < 13 = Velocity 0.3 0
  | otherwise = Velocity 0 0

light :: Bumper -> Maybe (Either Led1 Led2)
light (Bumper LeftBumper Pressed) = Just (Left (Led1 Orange))
light (Bumper RightBumper Pressed) = Just (Right (Led2 Orange))
light _ = Nothing

main = simulate (tour, light)
