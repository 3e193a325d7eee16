main = simulate (wait 4)
