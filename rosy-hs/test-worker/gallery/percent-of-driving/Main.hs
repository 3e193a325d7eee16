main = simulate (drive 50%)
