-- | Operator sections of every kind.
module Sections (main) where

import Data.List (sortBy)
import Data.Ord (comparing)

halves, doubles :: [Double] -> [Double]
halves = map (/ 2)
doubles = map (2 *)

shifted :: [Int] -> [Int]
shifted = map (subtract 1) . filter (>= 0) . map (`mod` 7) . map (7 `div`)

powers :: [Int]
powers = map (2 ^) [0 .. 8] ++ map (^ (2 :: Int)) [1 ..  3]

composed :: Int -> Int
composed = (. (+ 1)) (* 2) . ((+) <$> id <*> negate)

nested :: (Int -> Int) -> Int -> Int
nested = (.) ((+ 1) . (subtract 2)) . (.) (* 3)

sorted :: [(Int, String)] -> [(Int, String)]
sorted = sortBy (comparing snd <> comparing (negate . fst))

picky :: [[Int]] -> [[Int]]
picky = filter (not . null) . map (filter (/= 0)) . map (0 :) . map (++ [0]) . map ((: []) . sum)

applied :: [Int]
applied = map ($ 3) [(+ 1), subtract 1, (* 2), (`div` 2), (2 `div`), negate]

main = simulate (once (Velocity (head (halves [1])) 0))
