type Hit = Bool

bump :: Bumper -> Memory Hit
bump _ = Memory True

drive :: Memory Hit -> Velocity
drive (Memory hit) = Velocity (if hit then -0.2 else 0.3) 0

main = simulate (bump, drive)
