main = simulate (turn 1.57)
