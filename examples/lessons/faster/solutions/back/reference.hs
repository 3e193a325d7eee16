faster :: Velocity -> Velocity
faster (Velocity vl va) = Velocity (vl - 0.01) va

main = simulate faster
