go :: Velocity
go = Velocity 0.3 0

backOff :: Bumper -> Maybe Velocity
backOff (Bumper _ Pressed) = Just (Velocity (-0.15) 0)
backOff _ = Nothing

main :: IO ()
main = simulate (priority 1 backOff go)
