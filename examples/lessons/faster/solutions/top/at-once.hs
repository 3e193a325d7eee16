faster :: Velocity -> Velocity
faster (Velocity vl va) = Velocity (0.7) va

main = simulate faster
