main = simulate go

go :: Velocity -> Velocity
go (Velocity v w) = Velocity v of w

other = [1, 2
