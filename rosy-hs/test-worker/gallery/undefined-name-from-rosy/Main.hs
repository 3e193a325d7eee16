main = simulate move

move = Velocty 0.5 0
