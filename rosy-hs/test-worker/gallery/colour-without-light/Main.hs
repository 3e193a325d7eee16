main = simulate f
f :: Bumper -> Led1
f _ = Red
