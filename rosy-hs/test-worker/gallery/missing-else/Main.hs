main = simulate drive

drive :: Memory Bool -> Velocity
drive (Memory hit) = if hit then Velocity 0 0
