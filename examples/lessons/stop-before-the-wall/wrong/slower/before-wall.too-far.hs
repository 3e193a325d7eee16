go :: Ahead -> Velocity
go (Ahead distance)
  | distance > 1 = Velocity (distance - 0.5) 0
  | otherwise = Velocity 0 0

main = simulate go
