{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}

-- |
-- Module      : Rosy.Worker.Problem
-- Description : What the worker says about a program, as the protocol writes it.
--
-- Problems, declarations and the graph of a program ("protocol/README.md", sections 1 and 3). Pure data and
-- its JSON; where the words come from is the business of "Rosy.Worker.Kind".
module Rosy.Worker.Problem
  ( -- * Places
    Place (..),
    Span (..),

    -- * Problems
    Severity (..),
    Problem (..),
    Fix (..),
    Edit (..),
    isError,
    problemAt,
    problemNowhere,

    -- * What a program declares
    Declaration (..),
    Function (..),
    Typed (..),
    Report (..),
    emptyReport,

    -- * What can stand at a place
    Candidate (..),
    Completion (..),
  )
where

import Data.Aeson (Encoding, KeyValue, ToJSON (..), Value, object, pairs, (.=))
import Data.Text (Text)

-- | A line and a column, both from 1, counted in characters (a tab is one).
data Place = Place {line :: !Int, column :: !Int}
  deriving (Eq, Ord, Show)

-- | From a place up to, not including, another.
data Span = Span {start :: !Place, end :: !Place}
  deriving (Eq, Ord, Show)

data Severity = Error | Warning
  deriving (Eq, Ord, Show)

-- | Something a learner must know. @message@ says what, @hint@ why or what to do.
data Problem = Problem
  { severity :: !Severity,
    kind :: !Text,
    place :: !(Maybe Span),
    function :: !(Maybe Text),
    message :: !Text,
    hint :: !Text,
    ghc :: !Text,
    fixes :: ![Fix]
  }
  deriving (Eq, Show)

-- | One way to mend a problem: what a button for it says, and what to replace, all at once.
data Fix = Fix {title :: !Text, edits :: ![Edit]}
  deriving (Eq, Show)

-- | A piece of the program and the text that goes in its place.
data Edit = Edit {replaces :: !Span, by :: !Text}
  deriving (Eq, Show)

isError :: Problem -> Bool
isError p = severity p == Error

problemAt :: Span -> Text -> Text -> Text -> Problem
problemAt s k m h = (problemNowhere k m h) {place = Just s}

problemNowhere :: Text -> Text -> Text -> Problem
problemNowhere k m h = Problem Error k Nothing Nothing m h "" []

-- | A top-level name with its type as Haskell writes it; the span is the whole of its definition.
data Declaration = Declaration {declares :: !Text, ofType :: !Text, covers :: !Span}
  deriving (Eq, Show)

-- | A function that the robot runs, with what it takes and gives.
data Function = Function {called :: !Text, inputs :: ![Text], outputs :: ![Text]}
  deriving (Eq, Show)

-- | A piece of the text with its type as Haskell writes it.
data Typed = Typed {stands :: !Span, hasType :: !Text}
  deriving (Eq, Show)

-- | All that a check finds.
data Report = Report
  { problems :: ![Problem],
    declarations :: ![Declaration],
    functions :: ![Function],
    -- | In the order of the text, an outer piece before those inside it.
    types :: ![Typed]
  }
  deriving (Eq, Show)

emptyReport :: [Problem] -> Report
emptyReport ps = Report ps [] [] []

-- | A name in scope that fits, with its type and how many values must follow it.
data Candidate = Candidate {offers :: !Text, offersType :: !Text, takes :: !Int}
  deriving (Eq, Show)

-- | What is wanted at a place, if that is known, and what fits there, best first.
data Completion = Completion {expected :: !(Maybe Text), offered :: ![Candidate]}
  deriving (Eq, Show)

-- * As JSON

-- | As values and, which is several times as quick, straight as text.
asFields :: (forall kv. KeyValue kv => a -> [kv]) -> (a -> Value, a -> Encoding)
asFields fields = (object . fields, pairs . mconcat . fields)

instance ToJSON Candidate where
  toJSON = fst (asFields candidateFields)
  toEncoding = snd (asFields candidateFields)

candidateFields :: KeyValue kv => Candidate -> [kv]
candidateFields c = ["name" .= offers c, "type" .= offersType c, "takes" .= takes c]

instance ToJSON Place where
  toJSON = fst (asFields placeFields)
  toEncoding = snd (asFields placeFields)

placeFields :: KeyValue kv => Place -> [kv]
placeFields (Place l c) = ["line" .= l, "column" .= c]

instance ToJSON Problem where
  toJSON = fst (asFields problemFields)
  toEncoding = snd (asFields problemFields)

problemFields :: KeyValue kv => Problem -> [kv]
problemFields p =
  [ "severity" .= (if isError p then "error" else "warning" :: Text),
    "kind" .= kind p,
    "message" .= message p,
    "hint" .= hint p,
    "ghc" .= ghc p
  ]
    ++ maybe [] (\s -> ["start" .= start s, "end" .= end s]) (place p)
    ++ maybe [] (\f -> ["function" .= f]) (function p)
    ++ ["fixes" .= fixes p | not (null (fixes p))]

instance ToJSON Fix where
  toJSON = fst (asFields fixFields)
  toEncoding = snd (asFields fixFields)

fixFields :: KeyValue kv => Fix -> [kv]
fixFields f = ["title" .= title f, "edits" .= edits f]

instance ToJSON Edit where
  toJSON = fst (asFields editFields)
  toEncoding = snd (asFields editFields)

editFields :: KeyValue kv => Edit -> [kv]
editFields e = ["start" .= start (replaces e), "end" .= end (replaces e), "text" .= by e]

instance ToJSON Declaration where
  toJSON = fst (asFields declarationFields)
  toEncoding = snd (asFields declarationFields)

declarationFields :: KeyValue kv => Declaration -> [kv]
declarationFields d = ["name" .= declares d, "type" .= ofType d, "start" .= start (covers d), "end" .= end (covers d)]

instance ToJSON Function where
  toJSON = fst (asFields functionFields)
  toEncoding = snd (asFields functionFields)

functionFields :: KeyValue kv => Function -> [kv]
functionFields f = ["name" .= called f, "inputs" .= inputs f, "outputs" .= outputs f]
