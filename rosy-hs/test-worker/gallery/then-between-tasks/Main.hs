main = simulate (drive 50 then turn 90)
