main = simulate f
f :: StdGen -> Velocity
f g = Velocity (random g) 0
