main = simulate (Velocity 0.175 0)
