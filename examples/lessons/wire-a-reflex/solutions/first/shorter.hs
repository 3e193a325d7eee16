go :: Velocity
go = Velocity 0.4 0

backOff :: Bumper -> Velocity
backOff (Bumper side status) = Velocity (-0.2) 0

main :: IO ()
main = simulate (priority 0.5 backOff go)
