act :: Either RobotStatus Bumper -> Velocity
act (Left _) = Velocity 0.3 0
act (Right _) = Velocity (-0.15) 0

main = simulate act
