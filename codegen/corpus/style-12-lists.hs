{-# LANGUAGE ParallelListComp #-}
-- Lists built in every way.
squares :: [Int]
squares = [n * n | n <- [1 .. 10], odd n]

pairs :: [(Int, Int)]
pairs = [(a, b) | a <- [1 .. 3], b <- [a .. 3], let c = a + b, c /= 4]

triples :: Int -> [(Int, Int, Int)]
triples n =
  [ (a, b, c)
  | c <- [1 .. n]
  , b <- [1 .. c]
  , a <- [1 .. b]
  , a * a + b * b == c * c
  ]

nested :: [[Int]]
nested = [[x | x <- xs, even x] | xs <- [[1, 2], [3, 4 ..9], []]]

sequences :: [[Double]]
sequences = [[1 ..] , [1, 3 ..], [0, 0.1 .. 1], [10, 9 .. 1], take 3 [x | x <- [0 ..]], [1..2], [a..b], [a,b..]]
  where a = 1; b = 2

justs :: [Maybe a] -> [a]
justs ms = [x | Just x <- ms]

letters :: String
letters = ['a' .. 'z'] ++ [c | c <- "Hello", c `elem` ['A' .. 'Z']]

beside :: [(Int, Char)]
beside = [(n, c) | n <- [1 ..] | c <- "abc"]

spiral :: [Velocity]
spiral = [Velocity v (1 / v) | i <- [1 :: Int .. 5], let v = fromIntegral i / 10, then' i]
  where then' = (> 2)

main = simulate (once (head spiral))
