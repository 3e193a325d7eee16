main = simulate decide

decide :: Bumper -> Bool
decide (Bumper _ Pressed) = True
decide _ = False
