main = simulate (Velocity (1\2) 0)
