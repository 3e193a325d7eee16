go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

light :: Wheel -> Led1
light (Wheel _ Air) = Led1 Red
light _ = Led1 Black

halt :: Wheel -> Velocity
halt (Wheel _ Air) = Velocity 0 0
halt _ = Velocity 0.3 0

main = simulate (go, light, halt)
