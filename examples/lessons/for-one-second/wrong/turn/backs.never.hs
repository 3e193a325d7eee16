bump :: Bumper -> Seconds -> Memory Seconds
bump _ now = Memory (now + 1)

drive :: Memory Seconds -> Seconds -> Velocity
drive _ _ = Velocity 0.3 0

main = simulate (bump, drive)
