type Hit = Bool

bump :: Bumper -> Memory Hit
bump _ = Memory True

drive :: Memory Hit -> Velocity
drive _ = Velocity 0.3 0

main = simulate (bump, drive)
