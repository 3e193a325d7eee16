go :: RobotStatus -> Velocity
go _ = Velocity 0.3 0

backOff :: Bumper -> Velocity
backOff (Bumper side status) = Velocity (-0.2) 0

main :: IO ()
main = simulate (go, backOff)
