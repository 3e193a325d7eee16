int speed = 5

main = simulate (drive speed)
