go :: RobotStatus -> Velocity
go _ = Velocity 0.3 0

turn :: Bumper -> Velocity
turn (Bumper _ Pressed) = Velocity (-0.2) 0.5
turn (Bumper _ Released) = Velocity 0.3 0.3

count :: Bumper -> Memory Int -> Memory Int
count (Bumper _ Pressed) (Memory n) = Memory (n + 1)
count _ memory = memory

say :: Bumper -> Memory Int -> Maybe Say
say (Bumper _ Pressed) (Memory n) = Just (Say (show n))
say _ _ = Nothing

main = simulate (go, turn, count, say)
