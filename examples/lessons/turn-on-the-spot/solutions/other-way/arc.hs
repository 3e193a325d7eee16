main = simulate (Velocity 0.1 (-0.5))
