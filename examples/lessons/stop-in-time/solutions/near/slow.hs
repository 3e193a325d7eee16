go :: Position -> Velocity
go (Position x _)
  | x < 1.45 = Velocity 0.25 0
  | otherwise = Velocity 0 0

main = simulate go
