Main = simulate f
f :: Bumper -> Sound
f _ = ErrorSound
