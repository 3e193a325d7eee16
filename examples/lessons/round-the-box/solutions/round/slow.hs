main = simulate (Velocity 0.24 0.16)
