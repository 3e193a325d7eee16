stop :: Position -> Velocity
stop (Position x y)
  | x &gt; 2 = Velocity 0 0
  | otherwise = Velocity 0.2 0

main = simulate stop
