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

-- Whether something is pressed in.
type Touching = Bool

touch :: Bumper -> Memory Touching
touch (Bumper _ status) = Memory (status == Pressed)

cruise :: Memory Touching -> Position -> Maybe Velocity
cruise (Memory True) _ = Nothing
cruise (Memory False) _ = Just (Velocity 0.2 0)

main :: IO ()
main = simulate (touch, cruise, safetyControl)
