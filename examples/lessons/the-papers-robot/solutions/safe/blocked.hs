-- Two functions send an event of their own, and one answers it. In the air the robot stands.
data Blocked = Blocked

data Mode = Go | Stop | Back Seconds | Turn Seconds

bumper :: Bumper -> Maybe Blocked
bumper (Bumper _ Pressed) = Just Blocked
bumper _ = Nothing

cliff :: Cliff -> Maybe Blocked
cliff (Cliff _ Hole) = Just Blocked
cliff _ = Nothing

wheel :: Wheel -> Memory Mode
wheel (Wheel _ Air) = Memory Stop
wheel (Wheel _ Ground) = Memory Go

react :: Blocked -> Seconds -> Memory Mode
react Blocked now = Memory (Back (now + 1))

next :: Memory Mode -> StdGen -> Seconds -> Memory Mode
next (Memory (Back end)) gen now
  | now > end = Memory (Turn (now + doubleToSeconds time))
  where
    (time, _) = randomR (0.5, 3) gen
next (Memory (Turn end)) _ now
  | now > end = Memory Go
next mode _ _ = mode

drive :: Memory Mode -> (Velocity, Led1)
drive (Memory Go) = (Velocity 0.2 0, Led1 Black)
drive (Memory Stop) = (Velocity 0 0, Led1 Red)
drive (Memory (Back _)) = (Velocity (-0.1) 0, Led1 Orange)
drive (Memory (Turn _)) = (Velocity 0 1, Led1 Orange)

main = simulate (bumper, cliff, wheel, react, next, drive)
