main = simulate f
f :: Orientation -> Velocity
f o = Velocity 0 o
