go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

back :: Either Bumper Cliff -> (Velocity, Led1)
back _ = (Velocity (-0.1) 0, Led1 Red)

main = simulate (go, back)
