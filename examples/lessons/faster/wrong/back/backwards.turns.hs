back :: Velocity -> Velocity
back (Velocity v w) = Velocity v (w - 0.01)

main = simulate back
