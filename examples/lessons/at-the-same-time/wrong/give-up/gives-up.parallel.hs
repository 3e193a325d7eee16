main = simulate (parallel (drive 500) (wait 4))
