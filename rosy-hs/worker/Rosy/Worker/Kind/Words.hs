{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind.Words
-- Description : Small tools for taking GHC's sentences apart and putting ours together.
--
-- Pure text. Nothing here knows a particular message.
module Rosy.Worker.Kind.Words
  ( -- * Taking apart
    flat,
    quotes,
    after,
    between,
    Type,
    typeIn,
    splitArrows,
    atoms,
    isFunction,

    -- * Putting together
    quoted,
    a,
    simple,
    scrub,
    sentenceList,
    number,
    snippet,
  )
where

import Data.Char (isAlphaNum, isDigit, isLower, isSpace)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Problem (Place (..), Span (..))

-- | On one line with single spaces.
flat :: Text -> Text
flat = Text.unwords . Text.words

-- | What stands between ‘ and ’, in order.
quotes :: Text -> [Text]
quotes t = case Text.breakOn "‘" t of
  (_, rest) | Text.null rest -> []
  (_, rest) ->
    let (inside, more) = Text.breakOn "’" (Text.drop 1 rest)
     in inside : quotes (Text.drop 1 more)

-- | The rest after the first occurrence.
after :: Text -> Text -> Maybe Text
after mark t = case Text.breakOn mark t of
  (_, rest) | Text.null rest -> Nothing
  (_, rest) -> Just (Text.drop (Text.length mark) rest)

-- | What stands between two marks, or from the first to the end.
between :: Text -> Text -> Text -> Maybe Text
between from to t = Text.strip . fst . Text.breakOn to <$> after from t

-- | A type as text.
type Type = Text

-- | A type with or without quotes around it.
typeIn :: Text -> Type
typeIn t = case quotes t of
  q : _ | "‘" `Text.isPrefixOf` Text.strip t -> simple q
  _ -> simple t

-- | A type as GHC writes it, made simpler: String for a list of characters, no numbers on type variables, no module names.
simple :: Type -> Type
simple = Text.replace "[Char]" "String" . Text.concat . map word . tokens . flat
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

-- | Inputs and result of a function type; brackets are respected.
splitArrows :: Type -> [Type]
splitArrows t = map Text.strip (go (0 :: Int) "" (unwrapped t))
  where
    go _ acc "" = [acc]
    go depth acc rest
      | depth == 0, Just more <- Text.stripPrefix "->" rest = acc : go 0 "" more
      | otherwise = case Text.uncons rest of
        Just (c, more)
          | c `elem` ("([" :: String) -> go (depth + 1) (Text.snoc acc c) more
          | c `elem` (")]" :: String) -> go (depth - 1) (Text.snoc acc c) more
          | otherwise -> go depth (Text.snoc acc c) more
        Nothing -> [acc]
    -- A constraint says nothing to a learner.
    unwrapped x = maybe x Text.strip (after "=>" x)

isFunction :: Type -> Bool
isFunction t = length (splitArrows t) > 1

-- | The parts of a type that is applied: @Memory (Maybe Int)@ is @Memory@ and @(Maybe Int)@.
atoms :: Type -> [Type]
atoms = filter (not . Text.null) . go (0 :: Int) ""
  where
    go depth acc rest = case Text.uncons rest of
      Nothing -> [acc]
      Just (c, more)
        | c `elem` ("([" :: String) -> go (depth + 1) (Text.snoc acc c) more
        | c `elem` (")]" :: String) -> go (depth - 1) (Text.snoc acc c) more
        | isSpace c, depth == 0 -> acc : go 0 "" more
        | otherwise -> go depth (Text.snoc acc c) more

quoted :: Text -> Text
quoted t = "‘" <> t <> "’"

-- | With its article: a ‘Velocity’, an ‘Int’.
a :: Type -> Text
a t
  | isFunction t = "a function ‘" <> t <> "’"
  | Just (c, _) <- Text.uncons t, c `elem` ("AEIO" :: String) = "an " <> quoted t
  | otherwise = "a " <> quoted t

-- | ‘a’, ‘b’ or ‘c’.
sentenceList :: [Text] -> Text
sentenceList xs = case xs of
  [] -> ""
  [x] -> quoted x
  _ -> Text.intercalate ", " (map quoted (init xs)) <> " or " <> quoted (last xs)

number :: Int -> Text
number n = case n of
  0 -> "none"
  1 -> "one"
  2 -> "two"
  3 -> "three"
  4 -> "four"
  5 -> "five"
  6 -> "six"
  _ -> Text.pack (show n)

-- | GHC's text without what Rosy added: @(simulateNamed Name "x") x@ is @simulate x@ again.
scrub :: Text -> Text
scrub = Text.replace "simulateNamed" "simulate" . Text.replace "taskNamed" "task" . Text.replace "taskWithNamed" "taskWith" . Text.replace "onceNamed" "once" . Text.replace "callNamed" "call" . unwrap
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
snippet source (Span (Place l1 c1) (Place l2 c2))
  | l1 == l2, c2 - c1 <= 30, l : _ <- drop (l1 - 1) (Text.splitOn "\n" source) = Just (Text.take (c2 - c1) (Text.drop (c1 - 1) l))
  | otherwise = Nothing
