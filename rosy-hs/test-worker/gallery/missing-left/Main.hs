main = simulate f
f :: Bumper -> Either Sound Led1
f (Bumper _ Pressed) = ErrorSound
f _ = Led1 Red
