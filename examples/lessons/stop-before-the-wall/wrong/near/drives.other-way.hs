go :: Ahead -> Velocity
go (Ahead distance)
  | distance < 0.5 = Velocity 0.3 0
  | otherwise = Velocity 0 0

main = simulate go
