safetyControl :: Either (Either Bumper Cliff) Wheel -> Maybe Velocity
safetyControl (Left (Left (Bumper LeftBumper Pressed))) = Just (Velocity (-0.1) (-0.4))
safetyControl (Left (Left (Bumper RightBumper Pressed))) = Just (Velocity (-0.1) 0.4)
safetyControl (Left (Left (Bumper CenterBumper Pressed))) = Just (Velocity (-0.1) 0)
safetyControl (Left (Right (Cliff _ Hole))) = Just (Velocity (-0.1) 0)
safetyControl (Right (Wheel _ Air)) = Just (Velocity 0 0)
safetyControl _ = Nothing

main :: IO ()
main = simulate safetyControl
