go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

lift :: Wheel -> (Led1, Velocity)
lift _ = (Led1 Red, Velocity 0.1 0)

main = simulate (go, lift)
