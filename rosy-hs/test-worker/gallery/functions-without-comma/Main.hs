go = Velocity 0.5 0
play :: Bumper -> Sound
play _ = ErrorSound
main = simulate (go play)
