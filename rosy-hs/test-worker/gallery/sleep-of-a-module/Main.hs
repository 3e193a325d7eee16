main = simulate dance

dance = do
  drive 20
  time.sleep(1)
  turn 90
