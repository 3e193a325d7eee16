main = simulate move

move :: Velocity
move = Velocity "fast" 0
