main = simulate (race (wait 4) (drive 500))
