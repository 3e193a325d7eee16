start :: RobotStatus -> Velocity
start _ = Velocity 0.3 0

bump :: Bumper -> (Velocity, Sound)
bump _ = (Velocity (-0.3) 0, ButtonSound)

main = simulate (start, bump)
