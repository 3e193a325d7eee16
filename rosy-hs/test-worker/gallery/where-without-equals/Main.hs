go = Velocity speed 0
  where speed 0.3

main = simulate go
