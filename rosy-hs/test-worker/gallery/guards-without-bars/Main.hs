react :: Bumper -> Velocity
react (Bumper side _)
  side == LeftBumper = Velocity 0 1
  side == RightBumper = Velocity 0 (-1)
  otherwise = Velocity 0 0

main = simulate react
