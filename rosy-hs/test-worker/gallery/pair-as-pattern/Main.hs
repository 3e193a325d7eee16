drive :: Velocity -> Velocity
drive (v, w) = Velocity (v * 2) w

main = simulate drive
