faster :: Velocity -> Velocity
faster (Velocity vl va) = Velocity (vl + 0.002) va

main = simulate faster
