go :: Velocity
go = Velocity 0.3 0

shine :: Bumper -> Led1
shine (Bumper side status) = Led1 Red

backOff :: Bumper -> Velocity
backOff (Bumper side status) = Velocity (-0.2) 0

main :: IO ()
main = simulate (go, shine, backOff)
