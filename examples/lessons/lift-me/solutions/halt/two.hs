go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

light :: Wheel -> Led1
light _ = Led1 Red

halt :: Wheel -> Velocity
halt _ = Velocity 0 0

main = simulate (go, light, halt)
