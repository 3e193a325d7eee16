main = simulate (drive 50cm)
