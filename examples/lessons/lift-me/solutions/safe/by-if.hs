go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

lift :: Wheel -> (Led1, Velocity)
lift (Wheel _ s) = if s == Air then (Led1 Red, Velocity 0 0) else (Led1 Black, Velocity 0.2 0)

main = simulate (go, lift)
