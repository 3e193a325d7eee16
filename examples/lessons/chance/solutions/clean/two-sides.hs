data Mode = Go | Turn Double Seconds

bump :: Bumper -> StdGen -> Seconds -> Memory Mode
bump _ gen now = Memory (Turn side (now + doubleToSeconds time))
  where
    (time, more) = randomR (1, 4) gen
    (left, _) = random more
    side = if left then 1 else -1

drive :: Memory Mode -> Seconds -> Velocity
drive (Memory (Turn speed end)) now
  | now < end = Velocity 0 speed
drive _ _ = Velocity 0.5 0

main = simulate (bump, drive)
