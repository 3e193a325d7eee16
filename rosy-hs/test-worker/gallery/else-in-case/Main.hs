hit :: Bumper -> Velocity
hit b = case b of
  Bumper LeftBumper Pressed -> Velocity 0 1
  else -> Velocity 0 0

main = simulate hit
