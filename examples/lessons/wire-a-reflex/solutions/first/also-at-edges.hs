go :: Velocity
go = Velocity 0.3 0

backOff :: Either Bumper Cliff -> Velocity
backOff _ = Velocity (-0.2) 0

main :: IO ()
main = simulate (priority 1 backOff go)
