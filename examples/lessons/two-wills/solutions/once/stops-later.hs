go :: RobotStatus -> Velocity
go _ = Velocity 0.3 0

back :: Bumper -> Velocity
back (Bumper _ Pressed) = Velocity (-0.2) 0
back (Bumper _ Released) = Velocity (-0.1) 0

main = simulate (go, back)
