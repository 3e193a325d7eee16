main = simulate (Velocity 0.39 0)
