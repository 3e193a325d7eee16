class Shape a where
  sides :: a -> Int
data Square = Square
instance Shape Square where
  side _ = 4
main = simulate (Velocity 0 0)
