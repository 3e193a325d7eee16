import System.Random
-- chance: shuffles with generators handed on, and keeps its own generator in memory
dice :: () -> StdGen -> Memory [Int] -> Memory [Int]
dice () g (Memory ds) = Memory (fst (randomR (1, 6) g) : take 9 ds)

twice :: (StdGen, StdGen) -> Maybe Say
twice (a, b) = if (fst (random a) :: Int) == fst (random b) then Just (Say "same") else Nothing

sums :: Seconds -> Memory [Int] -> Maybe Say
sums t (Memory ds)
  | t >= 1 && t < 1.1 && all (`elem` [1 .. 6]) ds && length ds == 10 = Just (Say "ten dice")
  | otherwise = Nothing

main = simulate (dice, twice, sums)
