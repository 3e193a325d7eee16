start :: RobotStatus -> Velocity
start _ = Velocity 0.3 0

bump :: Bumper -> (Velocity, Sound)
bump _ = (Velocity (-0.3) 0, ErrorSound)

main = simulate (start, bump)
