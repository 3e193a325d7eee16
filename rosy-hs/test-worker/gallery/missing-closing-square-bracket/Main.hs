main = simulate [move, turn

move = Velocity 0.5 0

turn = Velocity 0 1
