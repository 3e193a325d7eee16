main = simulate move

move = let v = 0.5
