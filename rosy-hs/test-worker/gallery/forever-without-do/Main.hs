main = simulate $ do
  forever
    drive 50
    turn 90
