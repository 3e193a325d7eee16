main = simulate (Velocity 0 (-1))
