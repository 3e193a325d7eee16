go :: Seconds -> Velocity
go s
  | s < 5 = Velocity 1 0
  otherwise = Velocity 0 0
main = simulate go
