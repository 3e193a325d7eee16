go :: Velocity -> Velocity
go (Velocity v w) = Velocity (faster) w
  where
    faster x = x + 1
main = simulate go
