back :: Bumper -> Velocity
back _ = Velocity (-0.11) 0

go :: RobotStatus -> Velocity
go _ = Velocity 0.3 0

main = simulate (back, go)
