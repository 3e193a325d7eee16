faster :: Velocity -> Velocity
faster (Velocity vl va) = Velocity (vl - 0.001) va

main = simulate faster
