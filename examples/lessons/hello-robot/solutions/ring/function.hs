go :: Velocity -> Velocity
go _ = Velocity 0.4 0

main = simulate go
