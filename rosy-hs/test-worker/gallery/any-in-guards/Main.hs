go :: Button -> Velocity
go b
  | Button any Pressed /= b = Velocity 0 0
  | otherwise = Velocity 0.2 0

main = simulate go
