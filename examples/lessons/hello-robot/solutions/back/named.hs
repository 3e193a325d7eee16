back :: Velocity
back = Velocity (-0.2) 0

main = simulate back
