main = simulate (Velocity 0.2 (-50%))
