def go():
  return Velocity 0.5 0
main = simulate go
