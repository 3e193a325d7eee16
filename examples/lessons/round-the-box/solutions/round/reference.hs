main = simulate (Velocity 0.3 0.2)
