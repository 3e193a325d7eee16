main = simulate move

move = Velocity (twice 1) 0

twice f = f f
