main = simulate go

go :: Position -> Velocity
go (Position x _) = Velocity (2(x + 1)) 0
