data Mode = Go | Back | Turn | Rest

next :: Button -> Memory Mode -> Memory Mode
next (Button _ Pressed) (Memory Go) = Memory Back
next (Button _ Pressed) (Memory Back) = Memory Turn
next (Button _ Pressed) (Memory Turn) = Memory Rest
next (Button _ Pressed) (Memory Rest) = Memory Go
next _ mode = mode

drive :: Memory Mode -> Velocity
drive (Memory Go) = Velocity 0.2 0
drive (Memory Back) = Velocity (-0.2) 0
drive (Memory Turn) = Velocity 0 0.5
drive (Memory Rest) = Velocity 0 0

main = simulate (next, drive)
