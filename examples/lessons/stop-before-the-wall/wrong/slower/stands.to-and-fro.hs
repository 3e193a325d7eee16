go :: Ahead -> Velocity
go (Ahead distance)
  | distance > 1.2 = Velocity 0.6 0
  | distance > 0.5 = Velocity 0.2 0
  | otherwise = Velocity (-0.1) 0

main = simulate go
