go :: Velocity
go = Velocity 0.3 0

back :: Bumper -> Velocity
back _ = Velocity (-0.3) 0

main = simulate (go, back)
