go :: Velocity
go = Velocity 0.3 0

shine :: Bumper -> Led1
shine (Bumper side status) = Led1 Red

main :: IO ()
main = simulate (go, shine)
