main = do
  simulate (Velocity 0.5 0)
  simulate (Velocity 0 0)
