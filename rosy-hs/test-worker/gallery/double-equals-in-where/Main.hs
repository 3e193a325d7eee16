go :: Velocity -> Velocity
go (Velocity v w) = Velocity x w
  where x == v + 1
main = simulate go
