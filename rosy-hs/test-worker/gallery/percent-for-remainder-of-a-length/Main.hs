go :: Position -> Velocity
go (Position x _) = Velocity (x % 2) 0

main = simulate go
