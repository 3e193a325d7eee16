{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Problem
-- Description : Problems, declarations, types and completions as defined by the protocol.
--
-- Data types and JSON encodings of "protocol/README.md", sections 1 and 3. Pure. The sentences are chosen by "Rosy.Worker.Explanation".
module Rosy.Worker.Problem
  ( -- * Positions
    Position (..),
    Span (..),

    -- * Problems
    Severity (..),
    Problem (..),
    Fix (..),
    Edit (..),
    isError,
    problemAt,
    problemNowhere,

    -- * Declarations
    Declaration (..),
    Function (..),
    Typed (..),

    -- * Completion
    Candidate (..),
    Completion (..),
  )
where

import Data.Aeson (Encoding, Key, ToJSON (..), Value, object, pairs)
import qualified Data.Aeson as Aeson
import Data.Text (Text)
import Rosy.Worker.Sentence

-- | A line and a column, both from 1, counted in characters (a tab is one).
data Position = Position {line :: !Int, column :: !Int}
  deriving (Eq, Ord, Show)

-- | A half-open range of positions.
data Span = Span {start :: !Position, end :: !Position}
  deriving (Eq, Ord, Show)

-- | A note is advice about a program that does what it says.
data Severity = Error | Warning | Note
  deriving (Eq, Ord, Show)

-- | A diagnostic for the learner. @message@ states the problem, @hint@ the reason or the remedy.
data Problem = Problem
  { severity :: !Severity,
    kind :: !Text,
    place :: !(Maybe Span),
    function :: !(Maybe Text),
    message :: !Sentence,
    hint :: !Sentence,
    ghc :: !Text,
    fixes :: ![Fix]
  }
  deriving (Eq, Show)

-- | A quick fix: the label of its button and the edits to apply together.
data Fix = Fix {title :: !Sentence, edits :: ![Edit]}
  deriving (Eq, Show)

-- | A text replacement.
data Edit = Edit {replaces :: !Span, by :: !Text}
  deriving (Eq, Show)

isError :: Problem -> Bool
isError p = severity p == Error

problemAt :: Span -> Text -> Sentence -> Sentence -> Problem
problemAt s k m h = (problemNowhere k m h) {place = Just s}

problemNowhere :: Text -> Sentence -> Sentence -> Problem
problemNowhere k m h = Problem Error k Nothing Nothing m h "" []

-- | A top-level name with its type; the span covers the whole definition.
data Declaration = Declaration {declares :: !Text, ofType :: !Text, covers :: !Span}
  deriving (Eq, Show)

-- | A function connected to the robot, with its inputs and outputs.
data Function = Function {called :: !Text, inputs :: ![Text], outputs :: ![Text]}
  deriving (Eq, Show)

-- | A span of the text with its type.
data Typed = Typed {stands :: !Span, hasType :: !Text}
  deriving (Eq, Show)

-- | A name in scope that fits, with its type and the number of arguments it still needs.
data Candidate = Candidate {offers :: !Text, offersType :: !Text, takes :: !Int}
  deriving (Eq, Show)

-- | Expected type at the cursor, if known, and the candidates, best first.
data Completion = Completion {expected :: !(Maybe Text), offered :: ![Candidate]}
  deriving (Eq, Show)

-- * As JSON

-- | JSON as a value and, several times faster, as text.
asFields :: (a -> [Field]) -> (a -> Value, a -> Encoding)
asFields fields = (object . map (\(k := v) -> k Aeson..= v) . fields, pairs . foldMap (\(k := v) -> k Aeson..= v) . fields)

-- | One member of a JSON object.
data Field = forall v. ToJSON v => Key := v

instance ToJSON Candidate where
  toJSON = fst (asFields candidateFields)
  toEncoding = snd (asFields candidateFields)

candidateFields :: Candidate -> [Field]
candidateFields c = ["name" := offers c, "type" := offersType c, "takes" := takes c]

instance ToJSON Position where
  toJSON = fst (asFields placeFields)
  toEncoding = snd (asFields placeFields)

placeFields :: Position -> [Field]
placeFields (Position l c) = ["line" := l, "column" := c]

instance ToJSON Problem where
  toJSON = fst (asFields problemFields)
  toEncoding = snd (asFields problemFields)

problemFields :: Problem -> [Field]
problemFields p =
  [ "severity" := (case severity p of Error -> "error"; Warning -> "warning"; Note -> "note" :: Text),
    "kind" := kind p,
    "message" := english (message p),
    "hint" := english (hint p),
    "ghc" := ghc p
  ]
    ++ maybe [] (\s -> ["start" := start s, "end" := end s]) (place p)
    ++ maybe [] (\f -> ["function" := f]) (function p)
    ++ ["fixes" := fixes p | not (null (fixes p))]
    ++ ["sentences" := object sentences | not (null sentences)]
  where
    sentences = [k Aeson..= s | (k, Just s) <- [("message", sentenceId (message p)), ("hint", sentenceId (hint p))]]

instance ToJSON Fix where
  toJSON = fst (asFields fixFields)
  toEncoding = snd (asFields fixFields)

fixFields :: Fix -> [Field]
fixFields f = ["title" := english (title f), "edits" := edits f] ++ maybe [] (\s -> ["sentence" := s]) (sentenceId (title f))

instance ToJSON Edit where
  toJSON = fst (asFields editFields)
  toEncoding = snd (asFields editFields)

editFields :: Edit -> [Field]
editFields e = ["start" := start (replaces e), "end" := end (replaces e), "text" := by e]

instance ToJSON Declaration where
  toJSON = fst (asFields declarationFields)
  toEncoding = snd (asFields declarationFields)

declarationFields :: Declaration -> [Field]
declarationFields d = ["name" := declares d, "type" := ofType d, "start" := start (covers d), "end" := end (covers d)]

instance ToJSON Function where
  toJSON = fst (asFields functionFields)
  toEncoding = snd (asFields functionFields)

functionFields :: Function -> [Field]
functionFields f = ["name" := called f, "inputs" := inputs f, "outputs" := outputs f]
