go :: Seconds -> Velocity
go s = if s < 2 then Velocity 1 0 elif s < 3 then Velocity 0 1 else Velocity 0 0
main = simulate go
