bump :: Bumper -> StdGen -> Seconds -> Maybe (Memory Seconds)
bump (Bumper _ Pressed) gen now = Just (Memory (now + doubleToSeconds time))
  where
    (time, _) = randomR (1, 5) gen
bump _ _ _ = Nothing

drive :: Memory Seconds -> Seconds -> Velocity
drive (Memory end) now
  | now < end = Velocity 0 1
  | otherwise = Velocity 0.5 0

main = simulate (bump, drive)
