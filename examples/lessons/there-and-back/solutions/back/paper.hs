type Hit = Bool

bump :: Bumper -> Memory Hit
bump _ = Memory True

drive :: Memory Hit -> Velocity -> Velocity
drive (Memory hit) (Velocity vl va)
  | hit = Velocity (vl - 0.01) va
  | otherwise = Velocity (vl + 0.01) va

main = simulate (bump, drive)
