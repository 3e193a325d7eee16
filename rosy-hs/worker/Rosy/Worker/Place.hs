{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Place
-- Description : From the compiler's columns to the learner's.
--
-- GHC counts a tab as a jump to the next column after a multiple of eight; the protocol counts every character
-- once. Pure.
module Rosy.Worker.Place
  ( Columns,
    columnsOf,
    placeOf,
    spanOf,
  )
where

import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Problem (Place (..), Span (..))

-- | The lines of a text that have tabs; all others need no translation.
newtype Columns = Columns (IntMap Text)

columnsOf :: Text -> Columns
columnsOf source =
  Columns (IntMap.fromList [(n, l) | (n, l) <- zip [1 ..] (Text.splitOn "\n" source), Text.any (== '\t') l])

-- | A place from GHC's line and column.
placeOf :: Columns -> Int -> Int -> Place
placeOf (Columns tabbed) l c = Place l (maybe c (characterAt c) (IntMap.lookup l tabbed))

-- | GHC's column of each character in turn, until the wanted one is reached.
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

-- | A span from GHC's start and end; an empty one is widened to a character, so that it can be seen.
spanOf :: Columns -> (Int, Int) -> (Int, Int) -> Span
spanOf cols (l1, c1) (l2, c2)
  | b > a = Span a b
  | otherwise = Span a a {column = column a + 1}
  where
    a = placeOf cols l1 c1
    b = placeOf cols l2 c2
