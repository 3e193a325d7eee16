go :: Position -> Velocity
go (Position x y) = Velocity (x ^ 0.5) 0

main = simulate go
