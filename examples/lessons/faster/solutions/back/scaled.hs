faster :: Velocity -> Velocity
faster (Velocity vl va) = Velocity (vl * 1.05 - 0.005) va

main = simulate faster
