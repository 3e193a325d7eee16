drive :: Int -> Velocity
drive n = Velocity 0.2 0

main = simulate (do
  drive 50
  turn 90)
