data Way = There | Home

bump :: Bumper -> Memory Way
bump _ = Memory Home

drive :: Memory Way -> Velocity
drive (Memory There) = Velocity 0.3 0
drive (Memory Home) = Velocity (-0.3) 0

main = simulate (bump, drive)
