data Blocked = Blocked

go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

react :: Blocked -> (Velocity, Led1)
react Blocked = (Velocity (-0.1) 0, Led1 Red)

cliff :: Cliff -> Maybe Blocked
cliff (Cliff _ Hole) = Just Blocked
cliff _ = Nothing

bumper :: Bumper -> Maybe Blocked
bumper (Bumper _ Pressed) = Just Blocked
bumper _ = Nothing

main = simulate (react, cliff, bumper, go)
