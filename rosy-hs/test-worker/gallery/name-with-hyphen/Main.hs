my-speed = 0.2

main = simulate (Velocity my-speed 0)
