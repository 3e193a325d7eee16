main = simulate move

move :: Velocity
move = Velocity 0.5
