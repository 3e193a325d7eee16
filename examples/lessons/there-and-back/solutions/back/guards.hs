type Hit = Bool

bump :: Bumper -> Memory Hit
bump _ = Memory True

drive :: Memory Hit -> Velocity
drive (Memory hit)
  | hit = Velocity (-0.3) 0
  | otherwise = Velocity 0.3 0

main = simulate (bump, drive)
