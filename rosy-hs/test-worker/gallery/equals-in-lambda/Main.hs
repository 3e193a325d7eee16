main = simulate (\b = play b)

play :: Bumper -> Sound
play _ = ErrorSound
