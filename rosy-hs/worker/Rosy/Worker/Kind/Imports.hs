{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind.Imports
-- Description : Which allowed module brings a name that a program uses without an import.
--
-- The names that programs for learners use from the standard library beyond the Prelude and Rosy, and the short names under which modules are known.
-- Pure tables.
module Rosy.Worker.Kind.Imports
  ( importFor,
    moduleOf,
  )
where

import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text

-- | The module to import a name from.
importFor :: Text -> Maybe Text
importFor n = Map.lookup n homes

-- | The module that is mostly called so.
moduleOf :: Text -> Maybe Text
moduleOf q = lookup q short

short :: [(Text, Text)]
short = [("Map", "Data.Map"), ("Set", "Data.Set"), ("M", "Data.Map"), ("S", "Data.Set"), ("Seq", "Data.Sequence"), ("List", "Data.List"), ("Char", "Data.Char"), ("IntMap", "Data.IntMap")]

homes :: Map.Map Text Text
homes = Map.fromList [(n, m) | (m, names) <- table, n <- Text.words names]

table :: [(Text, Text)]
table =
  [ ("Data.List", "sort sortBy sortOn nub group groupBy partition intercalate intersperse transpose isPrefixOf isSuffixOf isInfixOf tails inits permutations subsequences insert delete union intersect foldl' maximumBy minimumBy genericLength unfoldr zipWith4 stripPrefix elemIndex findIndex"),
    ("Data.Char", "toUpper toLower isDigit isAlpha isUpper isLower isSpace isAlphaNum ord chr digitToInt intToDigit"),
    ("Data.Maybe", "fromMaybe mapMaybe catMaybes isJust isNothing fromJust listToMaybe maybeToList"),
    ("Data.Either", "lefts rights partitionEithers isLeft isRight fromLeft fromRight"),
    ("Data.Function", "on fix (&)"),
    ("Data.Ord", "comparing Down"),
    ("Data.Bits", "shiftL shiftR xor popCount testBit"),
    ("Data.Foldable", "for_ traverse_ toList foldrM"),
    ("Data.Traversable", "for mapAccumL mapAccumR"),
    ("Control.Applicative", "liftA2 ZipList optional"),
    ("Data.Functor", "void ($>) (<&>)"),
    ("Text.Read", "readMaybe"),
    ("Data.Ratio", "numerator denominator (%)")
  ]
