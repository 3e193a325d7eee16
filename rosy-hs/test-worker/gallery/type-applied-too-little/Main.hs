main = simulate drive

drive :: Memory -> Velocity
drive (Memory m) = Velocity m 0
