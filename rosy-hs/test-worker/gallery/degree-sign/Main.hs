main = simulate (turn 90°)
