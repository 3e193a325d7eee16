start :: RobotStatus -> Velocity
start _ = Velocity 0.3 0

bump :: Bumper -> (Velocity, Maybe Sound)
bump (Bumper _ Pressed) = (Velocity (-0.3) 0, Just ErrorSound)
bump (Bumper _ Released) = (Velocity (-0.3) 0, Nothing)

main = simulate (start, bump)
