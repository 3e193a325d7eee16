-- What the robot is doing. A turn has a speed and a time when it ends.
data Mode = Go | Stop | Turn Double Seconds

-- Sent when something is in the way.
data ChgDir = ChgDir

bumper :: Bumper -> (Led1, Maybe ChgDir)
bumper (Bumper _ Pressed) = (Led1 Orange, Just ChgDir)
bumper (Bumper _ Released) = (Led1 Black, Nothing)

wheel :: Wheel -> (Led1, Led2, Memory Mode)
wheel (Wheel _ Air) = (Led1 Red, Led2 Red, Memory Stop)
wheel (Wheel _ Ground) = (Led1 Black, Led2 Black, Memory Go)

-- Picks an angle from a quarter of a turn to half a turn, and a side.
chgdir :: ChgDir -> StdGen -> Seconds -> Memory Mode
chgdir ChgDir gen now = Memory (Turn speed (now + doubleToSeconds angle))
  where
    (angle, more) = randomR (1.5, pi) gen
    (left, _) = random more
    speed = if left then 1 else -1

spin :: Memory Mode -> Seconds -> Either Velocity (Memory Mode)
spin (Memory Go) _ = Left (Velocity 0.2 0)
spin (Memory Stop) _ = Left (Velocity 0 0)
spin (Memory (Turn speed end)) now
  | now < end = Left (Velocity (-0.1) speed)
  | otherwise = Right (Memory Go)

cliff :: Cliff -> Maybe ChgDir
cliff (Cliff _ Hole) = Just ChgDir
cliff _ = Nothing

main :: IO ()
main = simulate (bumper, cliff, wheel, chgdir, spin)
