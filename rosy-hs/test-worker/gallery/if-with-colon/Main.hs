go :: Memory Bool -> Velocity
go (Memory hit) =
  if hit:
    Velocity 0 0
  else:
    Velocity 0.2 0

main = simulate go
