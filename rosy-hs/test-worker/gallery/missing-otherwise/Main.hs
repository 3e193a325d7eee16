go :: Seconds -> Velocity
go s
  | s < 5 = Velocity 0.2 0
  | s < 10 = Velocity 0 0
main = simulate go
