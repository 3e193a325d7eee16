{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.TabStops
-- Description : Conversion of GHC columns to protocol columns.
--
-- GHC counts a tab as a jump to the next tab stop; the protocol counts every character once. Pure.
module Rosy.Worker.TabStops
  ( TabStops,
    tabStopsOf,
    positionFromGhc,
    spanFromGhc,
  )
where

import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Problem (Position (..), Span (..))

-- | The lines of a text that contain tabs. All other lines need no conversion.
newtype TabStops = TabStops (IntMap Text)

tabStopsOf :: Text -> TabStops
tabStopsOf source =
  TabStops (IntMap.fromList [(n, l) | (n, l) <- zip [1 ..] (Text.splitOn "\n" source), Text.any (== '\t') l])

-- | The position of GHC's line and column.
positionFromGhc :: TabStops -> Int -> Int -> Position
positionFromGhc (TabStops tabbed) l c = Position l (maybe c (characterAt c) (IntMap.lookup l tabbed))

-- | Number of the character at a GHC column.
characterAt :: Int -> Text -> Int
characterAt wanted = go 1 1 . Text.unpack
  where
    go n col rest
      | col >= wanted = n
      | otherwise = case rest of
        '\t' : more -> go (n + 1) (((col - 1) `div` tabStop + 1) * tabStop + 1) more
        _ : more -> go (n + 1) (col + 1) more
        [] -> n + (wanted - col)

-- | Haskell 2010 report, section 10.3: tab stops are eight characters apart.
tabStop :: Int
tabStop = 8

-- | The span between two GHC positions. An empty span is widened to one character to be visible.
spanFromGhc :: TabStops -> (Int, Int) -> (Int, Int) -> Span
spanFromGhc cols (l1, c1) (l2, c2)
  | b > a = Span a b
  | otherwise = Span a a {column = column a + 1}
  where
    a = positionFromGhc cols l1 c1
    b = positionFromGhc cols l2 c2
