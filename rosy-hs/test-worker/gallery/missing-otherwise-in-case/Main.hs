main = simulate go

go :: Seconds -> Velocity
go s = case s of
  Seconds x
    | x < 5 -> Velocity 0.2 0
    | x < 10 -> Velocity 0 1
