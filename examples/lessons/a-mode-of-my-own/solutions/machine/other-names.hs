data Mode = Ahead | Home | Spin

next :: Button -> Memory Mode -> Memory Mode
next (Button _ Pressed) (Memory Ahead) = Memory Home
next (Button _ Pressed) (Memory Home) = Memory Spin
next (Button _ Pressed) (Memory Spin) = Memory Ahead
next _ mode = mode

drive :: Memory Mode -> Velocity
drive (Memory Ahead) = Velocity 0.3 0
drive (Memory Home) = Velocity (-0.3) 0
drive (Memory Spin) = Velocity 0 1

main = simulate (next, drive)
