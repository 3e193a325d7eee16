{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.ParseFailure
-- Description : The place where GHC could not go on reading a program, with the tokens around it.
--
-- Holds what the checks of "Rosy.Worker.Explanation.SyntaxErrors" and "Rosy.Worker.Explanation.CommonSyntaxErrors" look at. Pure.
module Rosy.Worker.Explanation.ParseFailure
  ( ParseFailure (..),
    failureOf,
  )
where

import Data.Maybe (listToMaybe)
import Data.Text (Text)
import Rosy.Worker.Explanation.SurroundingTokens
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem

-- | The program where GHC could not go on.
data ParseFailure = ParseFailure
  { source :: Text,
    -- | GHC's code, from GHC 9.6 on.
    code :: Maybe Int,
    -- | GHC's message.
    messageText :: Text,
    -- | All tokens of the program.
    found :: [Token],
    -- | Where parsing failed.
    at :: Position,
    -- | The token there.
    here :: Maybe Token,
    -- | Its word.
    given :: Maybe Text,
    -- | The tokens of the current definition before the error.
    current :: [Token],
    -- | Their words.
    words' :: [Text],
    -- | The tokens on the line of the error.
    onLine :: [Token],
    -- | Those of them before it.
    onLineBefore :: [Token]
  }

-- | Takes the program, GHC's code (from GHC 9.6 on), its message and its span.
failureOf :: Text -> Maybe Int -> Text -> Maybe Span -> ParseFailure
failureOf source code messageText spot = ParseFailure {..}
  where
    found = tokenize source
    at = maybe (Position 1 1) start spot
    here = listToMaybe (dropWhile ((< at) . from) found)
    given = word <$> here
    current = reverse (takeDefinition (reverse (takeWhile ((< at) . from) found)))
    words' = map word current
    onLine = [t | t <- found, line (from t) == line at]
    onLineBefore = takeWhile ((< at) . from) onLine
