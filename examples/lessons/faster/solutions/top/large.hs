faster :: Velocity -> Velocity
faster (Velocity vl va) = Velocity (vl + 0.5) va

main = simulate faster
