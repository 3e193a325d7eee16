main = simulate (do
  robot.drive(50)
  robot.turn(90))
