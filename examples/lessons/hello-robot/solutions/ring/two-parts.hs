go :: Seconds -> Velocity
go now
  | now < 3 = Velocity 0.6 0
  | otherwise = Velocity 0.1 0

main = simulate go
