main = simulate play

play :: bumper -> Sound
play _ = ErrorSound
