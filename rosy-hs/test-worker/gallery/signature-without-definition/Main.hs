main = simulate move

move :: Velocity
