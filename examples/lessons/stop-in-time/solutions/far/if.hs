go :: Position -> Velocity
go (Position x y) = if x < 2.1 then Velocity 0.3 0 else Velocity 0 0

main = simulate go
