import qualified Data.Map as Map
import Data.List (sortBy, foldl')
import Data.Ord (comparing)
data Item a = Item { label :: String, weight :: a } deriving (Show, Eq, Ord)
newtype Bag a = Bag (Map.Map String (Item a))
class Weighs f where
  total :: Num a => f a -> a
instance Weighs Bag where
  total (Bag m) = foldl' (\acc i -> acc + weight i) 0 (Map.elems m)
put :: Button -> Memory (Bag Int) -> (Memory (Bag Int), Maybe Say)
put (Button n Pressed) (Memory (Bag m)) = (Memory bag, Just (Say (show (total bag))))
  where bag = Bag (Map.insertWith (\a b -> a { weight = weight a + weight b }) (show n) (Item (show n) 1) m)
put _ (Memory b) = (Memory b, Nothing)
main = simulate put
