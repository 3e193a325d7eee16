hit :: Bumper -> Velocity
hit b {
  Velocity 0 0
}

main = simulate hit
