bump :: Bumper -> StdGen -> Seconds -> Memory (Double, Seconds)
bump _ gen now = Memory (speed, now + doubleToSeconds time)
  where
    (time, more) = randomR (1, 4) gen
    (speed, _) = randomR (0.8, 1.2) more

drive :: Memory (Double, Seconds) -> Seconds -> Velocity
drive (Memory (speed, end)) now
  | now < end = Velocity 0 speed
  | otherwise = Velocity 0.5 0

main = simulate (bump, drive)
