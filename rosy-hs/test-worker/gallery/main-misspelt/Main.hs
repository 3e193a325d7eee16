mian = simulate (drive 50)
