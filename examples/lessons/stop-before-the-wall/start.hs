go :: Ahead -> Velocity
go (Ahead distance)
  | distance > 1 = Velocity 0.3 0
  | otherwise = Velocity 0 0

main = simulate go
