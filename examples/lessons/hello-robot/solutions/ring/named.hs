go :: Velocity
go = Velocity 0.4 0

main = simulate go
