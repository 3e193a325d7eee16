{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.MessageText
-- Description : Analysis of GHC's sentences and of the program's text.
--
-- Pure. Independent of particular messages.
module Rosy.Worker.Explanation.MessageText
  ( -- * Analysis
    oneLine,
    quotedParts,
    after,
    between,
    Type,
    typeIn,
    splitArrows,
    typeAtoms,
    isFunction,
    tupleParts,

    -- * Construction
    quoted,
    countOf,
    simplifyType,
    withoutGeneratedNames,
    snippet,
    lineOf,
    textAt,
  )
where

import Data.Char (isAlphaNum, isDigit, isLower)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.TypeText
import Rosy.Worker.Problem (Position (..), Span (..))

-- | On one line with single spaces.
oneLine :: Text -> Text
oneLine = Text.unwords . Text.words

-- | What stands between ‘ and ’, in order.
quotedParts :: Text -> [Text]
quotedParts t = case Text.breakOn "‘" t of
  (_, rest) | Text.null rest -> []
  (_, rest) ->
    let (inside, more) = Text.breakOn "’" (Text.drop 1 rest)
     in inside : quotedParts (Text.drop 1 more)

-- | What stands between two marks, or from the first to the end.
between :: Text -> Text -> Text -> Maybe Text
between from to t = Text.strip . fst . Text.breakOn to <$> after from t

-- | A type with or without quotes around it.
typeIn :: Text -> Type
typeIn t = case quotedParts t of
  q : _ | "‘" `Text.isPrefixOf` Text.strip t -> simplifyType q
  _ -> simplifyType t

-- | Simplifies a type: String for a list of characters, no numbers on type variables.
simplifyType :: Type -> Type
simplifyType = Text.replace "[Char]" "String" . Text.concat . map word . tokens . oneLine
  where
    word w
      | Just (c, _) <- Text.uncons w, isLower c, Text.any isDigit w = Text.dropWhileEnd isDigit w
      | otherwise = w

-- | Runs of name characters, and everything else one by one.
tokens :: Text -> [Text]
tokens t = case Text.uncons t of
  Nothing -> []
  Just (c, rest)
    | isName c -> let (w, more) = Text.span isName t in w : tokens more
    | otherwise -> Text.singleton c : tokens rest
  where
    isName x = isAlphaNum x || x == '_' || x == '\''

quoted :: Text -> Text
quoted t = "‘" <> t <> "’"

-- | A number as GHC writes it in a sentence: small ones as words.
countOf :: Text -> Maybe Int
countOf t = lookup t (zip ["none", "one", "two", "three", "four", "five", "six"] [0 ..] ++ [(Text.pack (show n), n) | n <- [7 .. 99]])

-- | GHC's text without generated code: @(simulateNamed Name "x") x@ is @simulate x@ again.
withoutGeneratedNames :: Text -> Text
withoutGeneratedNames = Text.replace "simulateNamed" "simulate" . Text.replace "taskNamed" "task" . Text.replace "taskWithNamed" "taskWith" . Text.replace "onceNamed" "once" . Text.replace "callNamed" "call" . unwrap
  where
    unwrap t = foldr drops t ["(simulateNamed ", "(taskNamed ", "(taskWithNamed ", "(onceNamed ", "(callNamed "]
    drops mark t = case Text.breakOn mark t of
      (before, rest)
        | Text.null rest -> t
        | otherwise -> before <> Text.drop 1 (Text.stripEnd mark) <> drops mark (closing (0 :: Int) (Text.drop (Text.length mark) rest))
    -- What follows the bracket that closes; strings may hold brackets.
    closing depth t = case Text.uncons t of
      Nothing -> ""
      Just ('"', rest) -> closing depth (Text.drop 1 (Text.dropWhile (/= '"') rest))
      Just (')', rest) | depth == 0 -> rest
      Just (c, rest)
        | c `elem` ("([" :: String) -> closing (depth + 1) rest
        | c `elem` (")]" :: String) -> closing (depth - 1) rest
        | otherwise -> closing depth rest

-- | The text of a span, if it is on one line and short enough to be repeated in a hint.
snippet :: Text -> Span -> Maybe Text
snippet source (Span (Position l1 c1) (Position l2 c2))
  | l1 == l2, c2 - c1 <= 30, l : _ <- drop (l1 - 1) (Text.splitOn "\n" source) = Just (Text.take (c2 - c1) (Text.drop (c1 - 1) l))
  | otherwise = Nothing

-- | A line by its number from 1; empty beyond the end.
lineOf :: Text -> Int -> Text
lineOf source l = fromMaybe "" (listToMaybe (drop (l - 1) (Text.splitOn "\n" source)))

-- | The text between two places.
textAt :: Text -> Span -> Text
textAt source (Span s e)
  | line s == line e = Text.take (column e - column s) (Text.drop (column s - 1) (lineOf source (line s)))
  | otherwise = Text.intercalate "\n" ([Text.drop (column s - 1) (lineOf source (line s))] ++ map (lineOf source) [line s + 1 .. line e - 1] ++ [Text.take (column e - 1) (lineOf source (line e))])
