main = simulate (Velocity 0.5)
