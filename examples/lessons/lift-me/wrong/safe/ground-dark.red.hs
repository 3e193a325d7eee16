go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

lift :: Wheel -> (Led1, Velocity)
lift (Wheel _ Air) = (Led1 Red, Velocity 0 0)
lift (Wheel _ Ground) = (Led1 Red, Velocity 0.2 0)

main = simulate (go, lift)
