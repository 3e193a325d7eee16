main = simulate (Led1 Red)
