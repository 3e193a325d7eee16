data Mode = Go Stop Turn
go :: Memory Mode -> Velocity
go (Memory Go) = Velocity 1 0
go _ = Velocity 0 0
main = simulate go
