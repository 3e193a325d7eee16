back :: Velocity -> Velocity
back (Velocity v _) = Velocity (v - 0.01) 0

main = simulate (back, Led1 Red)
