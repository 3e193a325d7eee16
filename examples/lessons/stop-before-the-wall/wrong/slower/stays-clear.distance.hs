go :: Ahead -> Velocity
go (Ahead distance) = Velocity distance 0

main = simulate go
