stop :: Position -> Velocity
stop (Position x y)
  l x > 2 = Velocity 0 0
  l otherwise = Velocity 0.2 0

main = simulate stop
