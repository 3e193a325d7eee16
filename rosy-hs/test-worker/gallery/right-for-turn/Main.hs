main = simulate (right 90)
