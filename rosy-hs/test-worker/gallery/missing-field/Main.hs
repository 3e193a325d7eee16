main = simulate move

move = Velocity { velocityLinear = 0.5 }
