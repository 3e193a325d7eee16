main = simulate f
f :: Bumper -> Led1
f _ = Led1 Blue
