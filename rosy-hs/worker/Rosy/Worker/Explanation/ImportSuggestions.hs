{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.ImportSuggestions
-- Description : Modules that export a name that is used without an import.
--
-- Tables of names of the standard library beyond the Prelude and Rosy, and of common module aliases. Pure.
module Rosy.Worker.Explanation.ImportSuggestions
  ( moduleExporting,
    moduleForAlias,
  )
where

import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text

-- | The module that exports a name.
moduleExporting :: Text -> Maybe Text
moduleExporting n = Map.lookup n homes

-- | The module with this common alias.
moduleForAlias :: Text -> Maybe Text
moduleForAlias q = lookup q short

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
    ("Data.Bifunctor", "bimap first second"),
    ("Data.Functor", "void ($>) (<&>)"),
    ("Text.Read", "readMaybe"),
    ("Data.Ratio", "numerator denominator (%)")
  ]
