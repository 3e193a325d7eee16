go :: Position -> Velocity
go (Position x _)
  | 1 < x < 2 = Velocity 0.2 0
  | otherwise = Velocity 0 0

main = simulate go
