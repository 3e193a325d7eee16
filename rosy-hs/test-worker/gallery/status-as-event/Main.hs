main = simulate f
f :: Bumper -> Sound
f Pressed = ErrorSound
