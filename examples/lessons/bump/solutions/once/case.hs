start :: RobotStatus -> Velocity
start _ = Velocity 0.3 0

bump :: Bumper -> (Velocity, Maybe Sound)
bump (Bumper _ status) = (Velocity (-0.3) 0, if status == Pressed then Just ErrorSound else Nothing)

main = simulate (start, bump)
