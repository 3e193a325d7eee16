main = simulate (Velocity 0.37 0)
