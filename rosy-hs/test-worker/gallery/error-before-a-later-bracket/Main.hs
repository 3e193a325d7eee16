main = simulate go

go :: Velocity -> Velocity
go (Velocity v w) = if v > 3 then Velocity 0 0

other = 3)
