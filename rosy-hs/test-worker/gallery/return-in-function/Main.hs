main = simulate f
f :: Bumper -> Velocity
f b = return (Velocity 0 1)
