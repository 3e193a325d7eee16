start :: RobotStatus -> Velocity
start _ = Velocity 0.3 0

bump :: Bumper -> (Velocity, Maybe Sound)
bump _ = (Velocity (-0.3) 0, Nothing)

main = simulate (start, bump)
