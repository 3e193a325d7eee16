hit :: Bumper -> Velocity
hit (Bumper Any Pressed) = Velocity 0 0
hit _ = Velocity 0.2 0

main = simulate hit
