start :: RobotStatus -> Velocity
start _ = Velocity 0.3 0

bump :: Bumper -> (Velocity, Sound)
bump (Bumper _ Pressed) = (Velocity (-0.3) 0, ButtonSound)
bump (Bumper _ Released) = (Velocity (-0.3) 0, ErrorSound)

main = simulate (start, bump)
