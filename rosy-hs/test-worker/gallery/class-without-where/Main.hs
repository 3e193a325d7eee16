class Shape a
  sides :: a -> Int
main = simulate (Velocity 0 0)
