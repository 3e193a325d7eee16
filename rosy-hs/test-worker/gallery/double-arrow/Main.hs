main = simulate f
f :: Bumper => Sound
f b = ErrorSound
