main = simulate (do
  drive 2m
  turn 90)
