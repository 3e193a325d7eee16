main = simulate (drive 1 000)
