main = simulate (race (drive) (wait 2))
drive = forever (Velocity 0.2 0)
