go :: RobotStatus -> Velocity
go _ = Velocity 0.2 0

back :: Either Bumper Cliff -> Maybe Velocity
back (Left (Bumper _ Pressed)) = Just (Velocity (-0.1) 0)
back (Right (Cliff _ Hole)) = Just (Velocity (-0.1) 0)
back _ = Nothing

main = simulate (go, back)
