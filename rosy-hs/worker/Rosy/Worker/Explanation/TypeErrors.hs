{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TypeErrors
-- Description : Explanations of type errors.
--
-- Finds out which family a message belongs to: ambiguous types, missing instances, or types that differ. A module explains each of them.
module Rosy.Worker.Explanation.TypeErrors
  ( explainTypes,
  )
where

import Control.Applicative ((<|>))
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.AmbiguousTypes
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.Mismatch (mismatchOf)
import Rosy.Worker.Explanation.MissingInstances
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Explanation.TypeMismatches
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

explainTypes :: ProgramOutline -> CompilerMessage -> Maybe Problem
explainTypes outline raw =
  (ambiguityIn raw messageText >>= \(v, c, user) -> Just (explainAmbiguous outline problem v c user))
    <|> (if "Overlapping instances for Runnable" `Text.isPrefixOf` messageText then Just (unclear outline problem) else Nothing)
    <|> (missingInstanceIn raw messageText >>= \(c, t, user) -> Just (explainInstance (missingInstanceOf outline raw problem c t user)))
    <|> (mismatchIn raw messageText >>= \(needed, given) -> Just (explainMismatch (mismatchOf outline raw problem needed given)))
    <|> (if "rigid type variable" `Text.isInfixOf` messageText then Just (problem "too-general" (tr "The type promises more than the definition keeps.") (tr "Write the type that it really has.")) else Nothing)
  where
    messageText = withoutGeneratedNames (oneLine (Text.unwords (important raw)))
    problem k m h = Problem (messageSeverity raw) k (messageSpan raw) Nothing m h "" []
