data Mode = Go | Stop

main = simulate drive

drive :: Memory Mode -> Velocity
drive (Memory m) = if m == Go then Velocity 0.5 0 else Velocity 0 0
