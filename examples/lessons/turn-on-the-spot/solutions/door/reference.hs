main = simulate (Velocity 0 0.39)
