go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

lift :: Wheel -> Led1
lift (Wheel _ Air) = Led1 Red
lift (Wheel _ Ground) = Led1 Black

main = simulate (go, lift)
