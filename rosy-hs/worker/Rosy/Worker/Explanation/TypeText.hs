{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TypeText
-- Description : Types as text, and their parts.
--
-- Brackets are respected. Pure.
module Rosy.Worker.Explanation.TypeText
  ( Type,
    after,
    splitArrows,
    typeAtoms,
    isFunction,
    tupleParts,
  )
where

import Data.Char (isSpace)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Sentence (isFunction)

-- | A type as text.
type Type = Text

-- | The rest after the first occurrence.
after :: Text -> Text -> Maybe Text
after mark t = case Text.breakOn mark t of
  (_, rest) | Text.null rest -> Nothing
  (_, rest) -> Just (Text.drop (Text.length mark) rest)

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

-- | The parts of a type that is applied: @Memory (Maybe Int)@ is @Memory@ and @(Maybe Int)@.
typeAtoms :: Type -> [Type]
typeAtoms = filter (not . Text.null) . go (0 :: Int) ""
  where
    go depth acc rest = case Text.uncons rest of
      Nothing -> [acc]
      Just (c, more)
        | c `elem` ("([" :: String) -> go (depth + 1) (Text.snoc acc c) more
        | c `elem` (")]" :: String) -> go (depth - 1) (Text.snoc acc c) more
        | isSpace c, depth == 0 -> acc : go 0 "" more
        | otherwise -> go depth (Text.snoc acc c) more

-- | The parts of a tuple, of its type or of its text; nothing for anything else.
tupleParts :: Text -> [Text]
tupleParts t = case Text.stripPrefix "(" (Text.strip t) >>= Text.stripSuffix ")" of
  Just inside | _ : _ : _ <- go (0 :: Int) "" inside -> map Text.strip (go (0 :: Int) "" inside)
  _ -> []
  where
    go depth acc rest = case Text.uncons rest of
      Nothing -> [acc]
      Just (c, more)
        | c `elem` ("([{" :: String) -> go (depth + 1) (Text.snoc acc c) more
        | c `elem` (")]}" :: String) -> go (depth - 1) (Text.snoc acc c) more
        | c == ',', depth == 0 -> acc : go 0 "" more
        | otherwise -> go depth (Text.snoc acc c) more
