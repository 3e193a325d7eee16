-- Classes, instances and where below their methods.
class Shape a where
  area :: a -> Double
  area = const 0
  perimeter, width :: a -> Double
  perimeter x = 2 * width x
  {-# MINIMAL width #-}

data Square = Square { side :: Double }
data Circle = Circle { radius :: !Double, label :: String }

instance Shape Square where
  area (Square a) = square a
    where
      square b = b * b
  perimeter s = 4 * side s
  width = side

instance Shape Circle where
  area c = pi * r * r where r = radius c
  width Circle {radius = r} = 2 * r

instance Show Square where
  showsPrec d (Square a) = showParen (d > 10) $
    showString "Square " . showsPrec 11 a

newtype Sum' = Sum' { total :: Double } deriving (Eq, Ord)

instance Semigroup Sum' where
  Sum' a <> Sum' b = Sum' (a + b)

instance Monoid Sum' where
  mempty = Sum' 0
  mappend = (<>)

sumOf :: [Double] -> Double
sumOf = total . foldMap Sum'

main = simulate (Velocity (sumOf [0.1, 0.2]) 0)
