back :: Bumper -> Velocity
back _ = Velocity (-0.3) 0

go :: Velocity
go = Velocity 0.3 0

main = simulate (back, go)
