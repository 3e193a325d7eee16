go :: Velocity
go = Velocity 0.3 0

backOff :: Bumper -> (Velocity, Led1)
backOff _ = (Velocity (-0.2) 0, Led1 Red)

main :: IO ()
main = simulate (priority 1 backOff go)
