main = simulate move

move = Velocity 0.5 0

play :: Bumper -> Sound
play _ = ErrorSound

move = Velocity 1 0
