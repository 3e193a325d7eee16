hit :: Bumper -> Velocity
hit (bumper _ pressed) = Velocity 0 0
hit _ = Velocity 0.2 0

main = simulate hit
