-- One function goes before another one, and both before a third: they are functions as without a priority.
backOff :: Bumper -> Velocity
backOff _ = Velocity (-0.2) 0

go :: Velocity
go = Velocity 0.3 0

turn :: Position -> Velocity
turn _ = Velocity 0 1

safely = priority 1 backOff go

main = simulate (priority 2 safely turn)
