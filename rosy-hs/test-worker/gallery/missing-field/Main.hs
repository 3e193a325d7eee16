main = simulate move

move = Velocity { positionX = 0.5 }
