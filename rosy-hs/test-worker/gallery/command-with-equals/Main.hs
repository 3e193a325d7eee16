main = simulate (do
  Led1 = Green
  drive 30)
