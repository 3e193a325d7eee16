data Blocked = Blocked

go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

bumper :: Bumper -> Maybe Blocked
bumper (Bumper _ Pressed) = Just Blocked
bumper _ = Nothing

cliff :: Cliff -> Maybe Blocked
cliff (Cliff _ Hole) = Just Blocked
cliff _ = Nothing

react :: Blocked -> (Velocity, Led1)
react Blocked = (Velocity (-0.1) 0, Led1 Red)

main = simulate (go, bumper, react)
