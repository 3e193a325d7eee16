main = simulate (Velocity 0.4 0)
