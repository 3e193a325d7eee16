go :: Ahead -> Velocity
go (Ahead d) = Velocity ((d - 0.5) * 0.6) 0

main = simulate go
