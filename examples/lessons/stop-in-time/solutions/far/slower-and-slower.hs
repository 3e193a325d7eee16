go :: Position -> Velocity
go (Position x _) = Velocity (min 0.5 (2.15 - x)) 0

main = simulate go
