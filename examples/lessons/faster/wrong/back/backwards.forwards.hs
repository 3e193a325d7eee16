faster :: Velocity -> Velocity
faster (Velocity vl va) = Velocity (vl + 0.02) va

main = simulate faster
