instance Command Velocity

main = simulate (Velocity 1 0)
