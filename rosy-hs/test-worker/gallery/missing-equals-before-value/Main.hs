main = simulate go

go :: Position -> Velocity
go (Position x y)
  Velocity 0.5 0
