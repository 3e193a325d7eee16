go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

back :: Cliff -> Velocity
back _ = Velocity (-0.1) 0

main = simulate (go, back)
