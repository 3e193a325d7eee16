main = simulate move

move = velocity 0.5 0
