main = simulate move

move = Velocity (Map.size m) 0
