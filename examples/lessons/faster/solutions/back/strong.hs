faster :: Velocity -> Velocity
faster (Velocity vl va) = Velocity (vl - 0.2) va

main = simulate faster
