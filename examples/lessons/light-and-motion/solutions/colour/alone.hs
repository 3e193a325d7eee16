main = simulate (Led1 Orange)
