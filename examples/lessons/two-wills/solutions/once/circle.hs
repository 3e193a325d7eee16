go :: RobotStatus -> Velocity
go _ = Velocity 0.3 0

back :: Bumper -> Velocity
back _ = Velocity (-0.2) 0.6

main = simulate (go, back)
