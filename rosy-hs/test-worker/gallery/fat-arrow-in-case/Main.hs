main = simulate hit

hit :: Bumper -> Velocity
hit b = case b of
  Bumper LeftBumper Pressed => Velocity 0 1
  _ -> Velocity 0 0
