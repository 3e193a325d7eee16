main = simulate go

go :: Seconds -> Velocity
go s = if | s < 5 -> Velocity 0.2 0
          | s < 10 -> Velocity 0 1
