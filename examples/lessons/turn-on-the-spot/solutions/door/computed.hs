main = simulate (Velocity 0 (pi / 8))
