main = simulate go

go :: Position -> Velocity
go (Position x y)
  if x > 1 then Velocity 0 0 else Velocity 0.5 0
