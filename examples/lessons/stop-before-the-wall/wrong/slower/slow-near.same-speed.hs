go :: Ahead -> Velocity
go (Ahead distance)
  | distance > 0.7 = Velocity 0.6 0
  | otherwise = Velocity 0 0

main = simulate go
