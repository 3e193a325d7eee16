hit :: Bumper -> Velocity
hit (Bumper, Pressed) = Velocity 0 1
hit _ = Velocity 0 0

main = simulate hit
