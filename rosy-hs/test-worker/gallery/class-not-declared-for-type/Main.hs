class Shape a where
  sides :: a -> Int
data Square = Square
go :: Bumper -> Say
go _ = Say (show (sides Square))
main = simulate go
