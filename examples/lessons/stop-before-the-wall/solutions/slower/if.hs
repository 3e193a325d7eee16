go :: Ahead -> Velocity
go (Ahead d) = if d > 0.55 then Velocity (d - 0.45) 0 else Velocity 0 0

main = simulate go
