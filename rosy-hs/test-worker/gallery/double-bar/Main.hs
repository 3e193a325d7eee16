hit :: Bumper -> Velocity
hit (Bumper s _)
  || s == LeftBumper = Velocity 0 1
  || otherwise = Velocity 0 0

main = simulate hit
