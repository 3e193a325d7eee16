main = simulate f
f :: LeftBumper -> Sound
f _ = ErrorSound
