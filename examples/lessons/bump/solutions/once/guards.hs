start :: RobotStatus -> Velocity
start _ = Velocity 0.3 0

bump :: Bumper -> (Velocity, Maybe Sound)
bump (Bumper _ s)
  | s == Pressed = (Velocity (-0.3) 0, Just ErrorSound)
  | otherwise = (Velocity (-0.3) 0, Nothing)

main = simulate (start, bump)
