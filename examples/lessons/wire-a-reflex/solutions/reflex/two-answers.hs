go :: Velocity
go = Velocity 0.3 0

shine :: Bumper -> (Led1, Velocity)
shine _ = (Led1 Red, Velocity (-0.1) 0)

main :: IO ()
main = simulate (go, shine)
