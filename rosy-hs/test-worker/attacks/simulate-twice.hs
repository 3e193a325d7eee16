main = simulate (Velocity 0 0) >> simulate (Velocity 1 0)
