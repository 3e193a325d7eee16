{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.CompletionHole
-- Description : Insertion of a typed hole at the cursor.
--
-- Replaces the name at or before the cursor by a hole. Pure.
module Rosy.Worker.CompletionHole
  ( holeName,
    insertHole,
  )
where

import Data.Char (isAlphaNum, isUpper)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Problem (Position (..))

-- | A name that programs do not use.
holeName :: Text
holeName = "_rosy'cursor"

-- | The text with the hole, and the start of the hole. Nothing if the position is outside of the text.
insertHole :: Position -> Text -> Maybe (Text, Position)
insertHole (Position l c) source = case splitAt (l - 1) (Text.splitOn "\n" source) of
  (above, here : below)
    | l >= 1,
      c >= 1,
      c <= Text.length here + 1 ->
      let (before, after) = Text.splitAt (c - 1) here
          kept = Text.dropEnd (Text.length (nameBefore before)) before
          left = Text.dropWhile isNameCharacter after
       in Just (Text.intercalate "\n" (above ++ [kept <> holeName <> left] ++ below), Position l (Text.length kept + 1))
  _ -> Nothing

-- | The name at the end of a text, with its module qualifier.
nameBefore :: Text -> Text
nameBefore t
  | Just rest <- Text.stripSuffix "." (Text.dropEnd (Text.length word) t),
    qualifier <- Text.takeWhileEnd isNameCharacter rest,
    Just (first, _) <- Text.uncons qualifier,
    isUpper first =
    nameBefore rest <> "." <> word
  | otherwise = word
  where
    word = Text.takeWhileEnd isNameCharacter t

isNameCharacter :: Char -> Bool
isNameCharacter c = isAlphaNum c || c == '_' || c == '\''
