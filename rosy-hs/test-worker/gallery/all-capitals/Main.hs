main = simulate (DRIVE 50)
