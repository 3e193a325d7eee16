hit :: bumper -> Velocity
hit _ = Velocity 0 0

main = simulate hit
