main = simulate (drive 50 backward)
