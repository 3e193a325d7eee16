import Data.Char (toUpper)
import qualified Data.Set as Set
import Text.Printf (printf)
import Control.Monad

data Shape = Circle { radius :: Double } | Square Double deriving (Eq, Ord, Show)

newtype Stack a = Stack [a]

push :: a -> Stack a -> Stack a
push x (Stack xs) = Stack (x : xs)

area :: Shape -> Double
area Circle { radius = r } = pi * r ^ 2
area (Square a) = a * a

put :: Button -> Memory (Stack Shape) -> Memory (Stack Shape)
put (Button Button0 Pressed) (Memory s) = Memory (push (Circle 1) s)
put (Button Button1 Pressed) (Memory s) = Memory (push (Square 2) s)
put _ m = m

look :: Button -> Memory (Stack Shape) -> Maybe Say
look (Button Button2 Pressed) (Memory (Stack xs)) = Just (Say (map toUpper (show (Set.fromList xs)) ++ show (round (sum (map area xs)) :: Int)))
look _ _ = Nothing

main :: IO ()
main = simulate (put, look)
