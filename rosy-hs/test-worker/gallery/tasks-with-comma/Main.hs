main = simulate (drive 50, turn 90)
