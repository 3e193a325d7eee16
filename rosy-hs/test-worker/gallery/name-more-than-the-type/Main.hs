main = simulate f
f :: Velocity
f x = Velocity 1 0
