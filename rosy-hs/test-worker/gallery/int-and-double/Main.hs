main = simulate move

steps :: Int
steps = 3

move :: Velocity
move = Velocity (steps * 0.5) 0
