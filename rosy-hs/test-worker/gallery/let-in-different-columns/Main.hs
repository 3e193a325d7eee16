go :: Velocity -> Velocity
go (Velocity v w) =
  let x = v + 1
     y = w
  in Velocity x y
main = simulate go
