go :: Ahead -> Velocity
go (Ahead distance) = Velocity (min 0.65 (distance - 0.5)) 0

main = simulate go
