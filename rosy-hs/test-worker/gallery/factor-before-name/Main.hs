go :: Position -> Velocity
go (Position x y) = Velocity (2x) 0

main = simulate go
