main = simulate play

play :: LeftBumper -> Sound
play _ = ErrorSound
