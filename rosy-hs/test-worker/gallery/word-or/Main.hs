go :: Position -> Velocity
go (Position x y) = if x > 1 OR y > 1 then Velocity 0 0 else Velocity 0.2 0

main = simulate go
