main = simulate f
f :: Bumper -> Velocity
f (Bumper Left Pressed) = Velocity 0 1
f _ = Velocity 0 0
