main = simulate move

move = Velocity (fromIntegral (Map.size Map.empty)) 0
