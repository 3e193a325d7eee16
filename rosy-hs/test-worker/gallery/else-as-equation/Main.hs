hit :: Bumper -> Velocity
hit (Bumper LeftBumper Pressed) = Velocity 0 1
else = Velocity 0 0

main = simulate hit
