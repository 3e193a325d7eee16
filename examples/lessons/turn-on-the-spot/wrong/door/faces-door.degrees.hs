main = simulate (Velocity 0 90)
