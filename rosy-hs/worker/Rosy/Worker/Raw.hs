-- |
-- Module      : Rosy.Worker.Raw
-- Description : What the compiler said, in our own nouns.
--
-- The border between "Rosy.Worker.Ghc", which fills these in, and "Rosy.Worker.Kind", which turns them into
-- sentences. Pure data.
module Rosy.Worker.Raw
  ( Raw (..),
    Reason (..),
    Outline (..),
    noOutline,
  )
where

import Data.Text (Text)
import Rosy.Worker.Problem (Function, Severity, Span)

-- | Why the compiler spoke, as far as it says so with a flag rather than with words.
data Reason
  = -- | It could not read the text.
    Syntax
  | -- | Names and types do not fit.
    Types
  | -- | A hole, @_@ or @_name@.
    Hole
  | -- | A name that nothing defines.
    Scope
  | -- | Cases are missing.
    IncompletePatterns
  | -- | A case can never happen.
    OverlappingPatterns
  | -- | A tab character.
    Tabs
  | -- | A record is built without some of its fields.
    MissingFields
  | -- | An instance lacks a function.
    MissingMethods
  | -- | Any other warning.
    Other
  deriving (Eq, Show)

-- | One message. The three lists are the parts of GHC's own document: what is wrong, where it is in the
-- program's structure (innermost first), and what may help.
data Raw = Raw
  { reason :: Reason,
    gravity :: Severity,
    region :: Maybe Span,
    important :: [Text],
    context :: [Text],
    supplementary :: [Text]
  }
  deriving (Eq, Show)

-- | What is known about a program besides its messages, for better sentences.
data Outline = Outline
  { -- | The program, as typed.
    text :: Text,
    -- | Top-level names with the places of their definitions, in order.
    bindings :: [(Text, Span)],
    -- | Top-level names with the places of their type signatures.
    signatures :: [(Text, Span)],
    -- | The functions that the robot runs.
    connectedTo :: [Function],
    -- | The same functions, in the same order, with the program's type synonyms replaced by what they stand for.
    spelledOut :: [Function]
  }

noOutline :: Text -> Outline
noOutline source = Outline source [] [] [] []
