main = simulate move

Velocity 0.5 0
