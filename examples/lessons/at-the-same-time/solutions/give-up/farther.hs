main = simulate (race (drive 400) (wait 4))
