go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

lift :: Wheel -> (Led1, Led2, Velocity)
lift (Wheel _ Air) = (Led1 Red, Led2 Red, Velocity 0 0)
lift _ = (Led1 Black, Led2 Black, Velocity 0.2 0)

main = simulate (go, lift)
