main = run (drive 50)
