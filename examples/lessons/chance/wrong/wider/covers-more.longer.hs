data Mode = Go | Turn Double Seconds

bump :: Bumper -> StdGen -> Seconds -> Memory Mode
bump _ gen now = Memory (Turn 1 (now + doubleToSeconds time))
  where
    (time, _) = randomR (6.2, 6.3) gen

drive :: Memory Mode -> Seconds -> Velocity
drive (Memory (Turn speed end)) now
  | now < end = Velocity 0 speed
drive _ _ = Velocity 0.5 0

main = simulate (bump, drive)
