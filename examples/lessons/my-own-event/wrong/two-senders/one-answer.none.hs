data Blocked = Blocked

go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

bumper :: Bumper -> Maybe Blocked
bumper (Bumper _ Pressed) = Just Blocked
bumper _ = Nothing

cliff :: Cliff -> Maybe Blocked
cliff (Cliff _ Hole) = Just Blocked
cliff _ = Nothing

main = simulate (go, bumper, cliff)
