data mode = Go | Stop

main = simulate (drive 50)
