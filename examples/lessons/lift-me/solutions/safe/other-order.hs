go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

lift :: Wheel -> (Velocity, Led1)
lift (Wheel _ Ground) = (Velocity 0.2 0, Led1 Black)
lift _ = (Velocity 0 0, Led1 Red)

main = simulate (go, lift)
