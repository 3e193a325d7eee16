main = simulate (Velocity 0.6 0)
