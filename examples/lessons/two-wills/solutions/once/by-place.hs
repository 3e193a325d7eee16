go :: Position -> Seconds -> Velocity
go _ now
  | now < 9.2 = Velocity 0.3 0
  | otherwise = Velocity (-0.2) 0

main = simulate go
