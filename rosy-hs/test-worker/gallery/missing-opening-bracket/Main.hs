main = simulate move, play)

move = Velocity 0.5 0

play :: Bumper -> Sound
play _ = ErrorSound
