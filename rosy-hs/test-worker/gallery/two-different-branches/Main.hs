main = simulate drive

drive :: Memory Bool -> Velocity
drive (Memory hit) = if hit then Led1 Red else Velocity 0.5 0
