main = simulate (Velocity 0.45 (0.45 / 1.5))
