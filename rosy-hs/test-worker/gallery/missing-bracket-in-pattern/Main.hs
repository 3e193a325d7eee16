main = simulate play

play :: Bumper -> Sound
play (Bumper _ Pressed = ErrorSound
play _ = OnSound
