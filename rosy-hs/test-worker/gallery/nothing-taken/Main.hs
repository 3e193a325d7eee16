main = simulate f
f :: () -> Velocity
f = Velocity 1 0
