import qualified Data.Map as Map
import Data.List (sortOn)
import Data.Maybe (fromMaybe)

-- Counts how often each bumper was pressed, with a map and a record of its own.
data Score = Score { hits :: Map.Map BumperSide Int, last' :: Maybe BumperSide }
  deriving (Show, Eq)

count :: Bumper -> Memory Score -> Memory Score
count (Bumper side Pressed) (Memory s) = Memory s { hits = Map.insertWith (+) side 1 (hits s), last' = Just side }
count _ m = m

report :: Button -> Memory Score -> Maybe Say
report (Button Button0 Pressed) (Memory s)
  | Map.null (hits s) = Just (Say "none")
  | otherwise = Just (Say (unwords [show k ++ "=" ++ show v | (k, v) <- sortOn (negate . snd) (Map.toList (hits s))]))
report _ _ = Nothing

main = simulate (count, report, Velocity 0.3 0)
