hit :: Bumper -> Velocity
hit (Bumper LeftBumper Pressed) = Velocity 0 1
otherwise = Velocity 0 0

main = simulate hit
