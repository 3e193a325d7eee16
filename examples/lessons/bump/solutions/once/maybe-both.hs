start :: RobotStatus -> Velocity
start _ = Velocity 0.3 0

bump :: Bumper -> Maybe (Velocity, Sound)
bump (Bumper _ Pressed) = Just (Velocity (-0.3) 0, ErrorSound)
bump _ = Nothing

main = simulate (start, bump)
