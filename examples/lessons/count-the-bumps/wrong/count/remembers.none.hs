go :: RobotStatus -> Velocity
go _ = Velocity 0.3 0

turn :: Bumper -> Velocity
turn (Bumper _ Pressed) = Velocity (-0.2) 0.5
turn (Bumper _ Released) = Velocity 0.3 0.3

say :: Bumper -> Maybe Say
say (Bumper _ Pressed) = Just (Say "1")
say _ = Nothing

main = simulate (go, turn, say)
