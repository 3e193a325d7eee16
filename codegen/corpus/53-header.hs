{-# LANGUAGE LambdaCase #-}
{-# OPTIONS_GHC -Wall #-}
module Main (main) where

import Rosy
import Data.List (sortBy)
import qualified Data.Map as Map

-- | How often each bumper was hit.
type Hits = [(BumperSide, Int)]

hit :: Bumper -> Memory Hits -> Memory Hits
hit (Bumper s Pressed) (Memory hs) = Memory (add s hs)
hit _ m = m

add :: BumperSide -> Hits -> Hits
add s [] = [(s, 1)]
add s ((t, n) : rest)
  | s == t = (t, n + 1) : rest
  | otherwise = (t, n) : add s rest

main :: IO ()
main = simulate hit
