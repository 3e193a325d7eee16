main = simulate (drive 50)

:-) the end
