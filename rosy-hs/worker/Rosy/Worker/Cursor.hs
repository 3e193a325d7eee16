{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Cursor
-- Description : A program with a hole where somebody is writing.
--
-- The name that the cursor stands in or behind gives way to a hole. Pure.
module Rosy.Worker.Cursor
  ( holeName,
    withHole,
  )
where

import Data.Char (isAlphaNum, isUpper)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Problem (Place (..))

-- | Nobody calls anything like this.
holeName :: Text
holeName = "_rosy'cursor"

-- | The text with the hole and where the hole begins; nothing when there is no such place.
withHole :: Place -> Text -> Maybe (Text, Place)
withHole (Place l c) source = case splitAt (l - 1) (Text.splitOn "\n" source) of
  (above, here : below)
    | l >= 1,
      c >= 1,
      c <= Text.length here + 1 ->
      let (before, after) = Text.splitAt (c - 1) here
          kept = Text.dropEnd (Text.length (nameBefore before)) before
          left = Text.dropWhile isNameCharacter after
       in Just (Text.intercalate "\n" (above ++ [kept <> holeName <> left] ++ below), Place l (Text.length kept + 1))
  _ -> Nothing

-- | The name at the end of a text, with the module it is qualified by.
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
