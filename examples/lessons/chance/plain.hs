data Mode = Go | Turn Double Seconds

bump :: Bumper -> Seconds -> Memory Mode
bump _ now = Memory (Turn 1 (now + 3.14))

drive :: Memory Mode -> Seconds -> Velocity
drive (Memory (Turn speed end)) now
  | now < end = Velocity 0 speed
drive _ _ = Velocity 0.5 0

main = simulate (bump, drive)
