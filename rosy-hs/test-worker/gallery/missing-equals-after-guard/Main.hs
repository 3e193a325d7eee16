main = simulate go

go :: Position -> Velocity
go (Position x _)
  | x > 1 Velocity 0 0
  | otherwise = Velocity 0.5 0
