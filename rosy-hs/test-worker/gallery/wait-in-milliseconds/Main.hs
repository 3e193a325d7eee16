main = simulate $ do
  beep
  wait 1000
  beep
