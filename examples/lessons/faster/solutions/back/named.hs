back :: Velocity -> Velocity
back (Velocity v w) = Velocity (v - 0.005) w

main = simulate back
