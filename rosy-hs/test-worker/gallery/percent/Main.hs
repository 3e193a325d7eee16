main = simulate (Velocity 50% 0)
