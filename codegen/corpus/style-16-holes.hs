-- A program that is being written.
import Data.List
  ( sort
  , nub -- later
  )
import Prelude hiding (lookup)

-- | What is still to do stands as a hole.
drive :: Position -> Velocity
drive (Position x y)
  | x > 1 = _turn
  | y > 1 = Velocity _ 0
  | otherwise = _

plan :: Task ()
plan = do
  _first
  x <- _ask
  say x
  _

table :: [(Int, String)]
table = [(1, _), (_two, "2")]

lookup :: Int -> [(Int, String)] -> Maybe String
lookup _ [] = Nothing
lookup k ((k', v) : rest)
  | k == k' = Just v
  | otherwise = lookup k rest

main = simulate drive
