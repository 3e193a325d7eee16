main = simulate f
f : Bumper -> Velocity
f b = Velocity 0 1
