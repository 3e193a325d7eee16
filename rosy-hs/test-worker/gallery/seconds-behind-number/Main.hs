main = simulate (wait 2s)
