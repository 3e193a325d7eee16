2fast = 0.6

main = simulate (Velocity 2fast 0)
