-- As little as possible has a name.
import Control.Monad
import Data.Function (on, (&))
import qualified Data.List as L
import Data.Maybe (fromMaybe, mapMaybe)

average :: [Double] -> Double
average = (/) <$> sum <*> fromIntegral . length

clamp :: Ord a => a -> a -> a -> a
clamp = (. max) . (.) . min

largest :: [(String, Double)] -> Maybe String
largest [] = Nothing
largest xs = Just . fst . L.maximumBy (compare `on` snd) $ xs

steer :: Double -> Velocity
steer = Velocity 0.2 . clamp (-1) 1 . negate . (* 0.5)

groups :: [Int] -> [[Int]]
groups = L.groupBy ((==) `on` (`div` 10)) . L.sort

total :: [Maybe Int] -> Int
total = sum . mapMaybe (>>= \n -> n <$ guard (n > 0))

pipeline :: [Int] -> Int
pipeline xs =
  xs
    & filter even
    & map (* 3)
    & L.foldl' (+) 0

patrol :: Task ()
patrol = mapM_ (\(s, t) -> once (Velocity s 0) >> wait t) =<< pure [(0.1, 1), (-0.1, 1)]

chained :: Task String
chained = pure "a" >>= \a -> pure (a ++ "b") >>= \b -> pure (b ++ "c") <* say b

safe :: [a] -> a -> a
safe = flip $ \d -> \case' -> case case' of
  [] -> d
  (x : _) -> x

main = simulate $ forever patrol `race` (chained >>= say)
