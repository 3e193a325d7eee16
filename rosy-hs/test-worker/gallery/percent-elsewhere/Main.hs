go :: Position -> Velocity
go (Position x y) = if x < 50% then Velocity 0.2 0 else Velocity 0 0

main = simulate go
