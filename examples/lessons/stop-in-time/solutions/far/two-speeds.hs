go :: Position -> Velocity
go (Position x _)
  | x < 1.5 = Velocity 0.5 0
  | x < 2.1 = Velocity 0.2 0
  | otherwise = Velocity 0 0

main = simulate go
