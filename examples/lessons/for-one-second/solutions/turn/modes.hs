data Mode = Go | Back Seconds | Turn Seconds

hit :: Bumper -> Seconds -> Memory Mode
hit _ now = Memory (Back (now + 1))

next :: Memory Mode -> Seconds -> Memory Mode
next (Memory (Back end)) now | now > end = Memory (Turn (now + 2))
next (Memory (Turn end)) now | now > end = Memory Go
next mode _ = mode

drive :: Memory Mode -> Velocity
drive (Memory Go) = Velocity 0.3 0
drive (Memory (Back _)) = Velocity (-0.2) 0
drive (Memory (Turn _)) = Velocity 0 0.8

main = simulate (hit, next, drive)
