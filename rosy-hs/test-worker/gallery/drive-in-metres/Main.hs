main = simulate (drive 0.5)
