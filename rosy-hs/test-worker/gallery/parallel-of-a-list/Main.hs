main = simulate (parallel [wait 1, wait 2])
