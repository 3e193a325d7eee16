data Mode = Go | Back | Turn
  deriving (Eq, Enum, Bounded)

next :: Button -> Memory Mode -> Memory Mode
next (Button _ Pressed) (Memory m)
  | m == maxBound = Memory minBound
  | otherwise = Memory (succ m)
next _ mode = mode

drive :: Memory Mode -> Velocity
drive (Memory Go) = Velocity 0.2 0
drive (Memory Back) = Velocity (-0.2) 0
drive (Memory Turn) = Velocity 0 0.5

main = simulate (next, drive)
