safetyControl :: Either (Either Bumper Cliff) Wheel -> Maybe Velocity
safetyControl (Right (Wheel _ Air)) = Just (Velocity 0 0)
safetyControl (Left (Left (Bumper side Pressed))) = Just (backOff side)
safetyControl (Left (Right (Cliff side Hole))) = Just (backOff (bumperAt side))
safetyControl _ = Nothing

-- Backwards, and away from the side that was hit.
backOff :: BumperSide -> Velocity
backOff CenterBumper = Velocity (-0.1) 0
backOff LeftBumper = Velocity (-0.1) (-0.4)
backOff RightBumper = Velocity (-0.1) 0.4

bumperAt :: CliffSide -> BumperSide
bumperAt CenterCliff = CenterBumper
bumperAt LeftCliff = LeftBumper
bumperAt RightCliff = RightBumper

-- Whether something keeps the robot from driving on.
type Blocked = Bool

watch :: Either (Either Bumper Cliff) Wheel -> Memory Blocked
watch (Left (Left (Bumper _ status))) = Memory (status == Pressed)
watch (Left (Right (Cliff _ status))) = Memory (status == Hole)
watch (Right (Wheel _ status)) = Memory (status == Air)

cruise :: Memory Blocked -> Position -> Maybe Velocity
cruise (Memory True) _ = Nothing
cruise (Memory False) _ = Just (Velocity 0.2 0)

main :: IO ()
main = simulate (watch, cruise, safetyControl)
