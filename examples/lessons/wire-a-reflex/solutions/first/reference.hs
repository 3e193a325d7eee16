backOff :: Bumper -> Velocity
backOff (Bumper side status) = Velocity (-0.2) 0

go :: Velocity
go = Velocity 0.3 0

main :: IO ()
main = simulate (priority 1 backOff go)
