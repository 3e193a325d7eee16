main = simulate f
f :: Bumper -> Velocity
f Bumper LeftBumper Pressed = Velocity 0 1
f _ = Velocity 0 0
