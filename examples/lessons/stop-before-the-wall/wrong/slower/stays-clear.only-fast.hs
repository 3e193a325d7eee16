go :: Ahead -> Velocity
go (Ahead _) = Velocity 0.6 0

main = simulate go
