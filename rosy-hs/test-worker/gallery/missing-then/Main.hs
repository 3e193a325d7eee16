main = simulate drive

drive :: Memory Bool -> Velocity
drive (Memory hit) = if hit Velocity 0 0 else Velocity 0.5 0
