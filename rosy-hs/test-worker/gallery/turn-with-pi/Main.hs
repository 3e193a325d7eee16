main = simulate (turn (pi / 2))
