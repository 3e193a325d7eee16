main = simulate (do
  drive 50
  turn left 90)
