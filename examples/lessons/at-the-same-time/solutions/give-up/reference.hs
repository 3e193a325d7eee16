main = simulate (race (drive 500) (wait 4))
