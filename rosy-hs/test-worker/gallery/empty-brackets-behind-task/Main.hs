main = simulate (do
  beep()
  drive 20)
