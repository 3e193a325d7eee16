main = simulate (Velocity (2 / 5) 0)
