import qualified Data.Map as Map

-- Names that come with Haskell, defined anew: the program's own are meant. What they hide is still there with its module's name.
data Side = Left | Right deriving (Eq, Show)

data Maybe a = No | Yes a

newtype V = V (Int, Int)

instance Num V where
  V (a, b) + V (c, d) = V (a + c, b + d)
  V (a, b) * V (c, d) = V (a * c, b * d)
  abs = id
  signum = id
  negate (V (a, b)) = V (negate a, negate b)
  fromInteger n = V (fromInteger n, 0)

instance Show V where
  show (V (a, b)) = Prelude.show a ++ "/" ++ Prelude.show b

map :: (a -> b) -> [a] -> [b]
map f xs = [f x | x <- xs]

length :: Maybe Int -> Int
length No = 0
length (Yes n) = n

show :: Show a => a -> String
show x = "<" ++ Prelude.show x ++ ">"

init :: Memory Int
init = Memory (length (Yes 3))

other :: Side -> Side
other Left = Right
other Right = Left

lookup :: () -> Memory Int -> Either Say (Done ())
lookup () (Memory n)
  | n == 3 = Prelude.Left (Say (concatMap show (map (+ 1) [1, n]) ++ show (other Left) ++ show (V (1, 2) + 3)))
  | otherwise = Prelude.Right (Done ())

count :: () -> Memory Int -> Memory Int
count () (Memory n) = Memory (n + Map.size (Map.fromList [(1, 'x')]))

main = simulate (task init (lookup, count))
