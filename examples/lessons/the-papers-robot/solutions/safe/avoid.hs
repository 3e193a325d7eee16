-- The newest danger decides the mode, so it needs no messages of two kinds.
data Mode = Go | Back Seconds | Turn Double Seconds

avoid :: Either Bumper Cliff -> Seconds -> Maybe (Memory Mode)
avoid (Left (Bumper _ Pressed)) now = Just (Memory (Back (now + 1)))
avoid (Right (Cliff _ Hole)) now = Just (Memory (Back (now + 1)))
avoid _ _ = Nothing

next :: Memory Mode -> StdGen -> Seconds -> Memory Mode
next (Memory (Back end)) gen now
  | now > end = Memory (Turn speed (now + doubleToSeconds angle))
  where
    (angle, more) = randomR (0.5, pi) gen
    (left, _) = random more
    speed = if left then 1 else -1
next (Memory (Turn _ end)) _ now
  | now > end = Memory Go
next mode _ _ = mode

drive :: Memory Mode -> Velocity
drive (Memory Go) = Velocity 0.2 0
drive (Memory (Back _)) = Velocity (-0.1) 0
drive (Memory (Turn speed _)) = Velocity 0 speed

main = simulate (avoid, next, drive)
