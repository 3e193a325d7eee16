main = simulate f
f :: Velocity -> Velocity
f v = v + 0.5
