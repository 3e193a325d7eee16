main = simulate move

  move = Velocity 0.5 0
