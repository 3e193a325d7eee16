simulate (drive 50)
