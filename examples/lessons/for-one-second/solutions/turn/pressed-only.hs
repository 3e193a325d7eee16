bump :: Bumper -> Seconds -> Maybe (Memory Seconds)
bump (Bumper _ Pressed) now = Just (Memory (now + 1))
bump _ _ = Nothing

drive :: Memory Seconds -> Seconds -> Velocity
drive (Memory end) now
  | now < end = Velocity (-0.2) 0
  | end > 0 && now < end + 2 = Velocity 0 0.8
  | otherwise = Velocity 0.3 0

main = simulate (bump, drive)
