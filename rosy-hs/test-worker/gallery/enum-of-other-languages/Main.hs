enum Mode = Go | Stop

main = simulate (drive 50)
