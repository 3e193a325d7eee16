main = simulate (Velocity 0 (-1.18))
