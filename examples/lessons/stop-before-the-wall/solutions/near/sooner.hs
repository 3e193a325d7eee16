go :: Ahead -> Velocity
go (Ahead distance)
  | distance > 0.55 = Velocity 0.4 0
  | otherwise = Velocity 0 0

main = simulate go
