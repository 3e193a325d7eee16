go :: Bumper, Velocity -> Velocity
go _ v = v
main = simulate go
