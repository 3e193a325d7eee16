{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.MessageParts
-- Description : A message of the compiler and what its sentences state.
--
-- Holds what the rules of "Rosy.Worker.Explanation.NameErrors" and "Rosy.Worker.Explanation.DefinitionErrors" look at. Pure.
module Rosy.Worker.Explanation.MessageParts
  ( MessageParts (..),
    messageParts,
    Rule,
  )
where

import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Problem

data MessageParts = MessageParts
  { outline :: ProgramOutline,
    raw :: CompilerMessage,
    problem :: Say,
    -- | The message without its context, on one line.
    messageText :: Text,
    -- | The message with its context, on one line.
    everything :: Text,
    -- | What the message quotes, in order.
    names :: [Text],
    firstName :: Text,
    -- | What stands on the line before the part that the message is about.
    before :: Text,
    -- | Whether the message has this text.
    mentions :: Text -> Bool,
    -- | By GHC's code where the message has one; by its prose where it has none, as in GHC 9.0.
    states :: Int -> Text -> Bool
  }

-- | Explains a message, or leaves it to another rule.
type Rule = MessageParts -> Maybe Problem

messageParts :: ProgramOutline -> CompilerMessage -> MessageParts
messageParts outline raw = MessageParts {..}
  where
    problem k m h = Problem (messageSeverity raw) k (messageSpan raw) Nothing m h "" []
    messageText = oneLine (Text.unwords (important raw))
    everything = oneLine (Text.unwords (important raw ++ context raw ++ supplementary raw))
    names = quotedParts messageText
    firstName = fromMaybe "this" (listToMaybe names)
    before = maybe "" (\s -> Text.take (column (start s) - 1) (lineAt outline s)) (messageSpan raw)
    mentions t = t `Text.isInfixOf` messageText
    states number t = maybe (mentions t) (== number) (messageCode raw)
