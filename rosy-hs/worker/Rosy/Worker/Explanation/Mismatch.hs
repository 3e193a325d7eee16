{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.Mismatch
-- Description : A message about two types that differ.
--
-- Holds what the rules of "Rosy.Worker.Explanation.MismatchCauses" and "Rosy.Worker.Explanation.TypeMismatches" look at. Pure.
module Rosy.Worker.Explanation.Mismatch
  ( Mismatch (..),
    mismatchOf,
    Rule,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Problem

data Mismatch = Mismatch
  { outline :: ProgramOutline,
    raw :: CompilerMessage,
    problem :: Say,
    -- | The expected type.
    needed :: Type,
    -- | The actual type.
    given :: Type,
    -- | The message without its context, on one line.
    messageText :: Text,
    -- | The message with its context, on one line.
    whole :: Text,
    -- | The part of the program that the message is about, if it is short and on one line.
    source :: Maybe Text,
    -- | What stands on the line before that part.
    before :: Text,
    -- | What stands on the line behind it.
    behind :: Text
  }

-- | Explains a mismatch, or leaves it to another rule.
type Rule = Mismatch -> Maybe Problem

-- | Takes the expected and the actual type.
mismatchOf :: ProgramOutline -> CompilerMessage -> Say -> Type -> Type -> Mismatch
mismatchOf outline raw problem needed given = Mismatch {..}
  where
    messageText = withoutGeneratedNames (oneLine (Text.unwords (important raw)))
    whole = withoutGeneratedNames (oneLine (Text.unwords (important raw ++ context raw ++ supplementary raw)))
    source = messageSpan raw >>= snippet (text outline)
    before = maybe "" (\s -> Text.take (column (start s) - 1) (lineAt outline s)) (messageSpan raw)
    behind = maybe "" (\s -> Text.drop (column (end s) - 1) (lineAt outline s)) (messageSpan raw)
