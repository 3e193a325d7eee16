data Blocked = Blocked

go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

sense :: Either Bumper Cliff -> Maybe Blocked
sense (Left (Bumper _ Pressed)) = Just Blocked
sense (Right (Cliff _ Hole)) = Just Blocked
sense _ = Nothing

react :: Blocked -> (Velocity, Led1)
react Blocked = (Velocity (-0.1) 0, Led1 Red)

main = simulate (go, sense, react)
