go :: Position -> Velocity
go (Position x _)
  | x > 2.1 = Velocity 0 0
  | otherwise = Velocity 0.4 0

main = simulate go
