go :: Ahead -> Velocity
go (Ahead d) = if d < 0.52 then Velocity 0 0 else Velocity 0.35 0

main = simulate go
