go :: RobotStatus -> Velocity
go _ = Velocity 0.3 0

turn :: Bumper -> Velocity
turn (Bumper _ Pressed) = Velocity (-0.2) 0.5
turn (Bumper _ Released) = Velocity 0.3 0.3

count :: Bumper -> Memory Int -> Maybe (Memory Int, Say)
count (Bumper _ Pressed) (Memory n) = Just (Memory (n + 1), Say (show (n + 1)))
count _ _ = Nothing

main = simulate (go, turn, count)
