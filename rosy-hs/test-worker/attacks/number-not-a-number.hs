main = simulate [Velocity (0 / 0) (1 / 0), Velocity (-1 / 0) 1e308]
