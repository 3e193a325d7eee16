go :: Position -> Velocity
go (Position x _)
  | x < 2.05 = Velocity 0.6 0
  | otherwise = Velocity 0 0

main = simulate go
