bump :: Bumper -> Seconds -> Memory Seconds
bump _ now = Memory (now + 1)

drive :: Memory Seconds -> Seconds -> Velocity
drive (Memory end) now
  | now < end = Velocity (-0.2) 0.5
  | end > 0 && now < end + 2 = Velocity 0 0.8
  | otherwise = Velocity 0.3 0

main = simulate (bump, drive)
