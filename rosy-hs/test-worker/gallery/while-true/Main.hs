main = simulate dance

dance = do
  while True:
    drive 50
    turn 90
