follow :: Orientation -> Velocity
follow o
  | o > 90 degrees = Velocity 0 0
  | otherwise = Velocity 0 1

main = simulate follow
