main = simulate spin

spin :: Velocity -> Velocity
spin v = spin v
