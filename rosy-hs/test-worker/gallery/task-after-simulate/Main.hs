main = do
  simulate (Velocity 0.5 0)
  wait 2
