main = simulate move

move = Velocity quickly 0
