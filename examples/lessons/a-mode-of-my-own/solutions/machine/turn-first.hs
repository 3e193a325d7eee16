data Mode = Turn | Go | Back

next :: Button -> Memory Mode -> Memory Mode
next (Button _ Pressed) (Memory Turn) = Memory Go
next (Button _ Pressed) (Memory Go) = Memory Back
next (Button _ Pressed) (Memory Back) = Memory Turn
next _ mode = mode

drive :: Memory Mode -> Velocity
drive (Memory Turn) = Velocity 0 0.5
drive (Memory Go) = Velocity 0.2 0
drive (Memory Back) = Velocity (-0.2) 0

main = simulate (next, drive)
