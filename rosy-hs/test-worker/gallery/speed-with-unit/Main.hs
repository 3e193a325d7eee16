speed = 0.2 m/s

main = simulate (Velocity speed 0)
