main = simulate (turn 25%)
