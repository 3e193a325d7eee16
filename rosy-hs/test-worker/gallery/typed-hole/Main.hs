main = simulate move

move :: Velocity
move = Velocity _ 0
