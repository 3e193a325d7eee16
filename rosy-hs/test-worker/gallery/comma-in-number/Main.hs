main = simulate (drive)
drive :: Velocity
drive = Velocity 0,5 0
