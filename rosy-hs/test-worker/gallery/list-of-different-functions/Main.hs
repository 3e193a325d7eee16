main = simulate [f, g]
f :: Bumper -> Sound
f _ = ErrorSound
g :: Cliff -> Led1
g _ = Led1 Red
