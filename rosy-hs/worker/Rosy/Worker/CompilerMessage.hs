-- |
-- Module      : Rosy.Worker.CompilerMessage
-- Description : Diagnostic messages of GHC in a form that is independent of GHC.
--
-- Interface between "Rosy.Worker.Ghc", which produces these values, and "Rosy.Worker.Explanation", which turns them into sentences
-- for learners. Pure data.
module Rosy.Worker.CompilerMessage
  ( CompilerMessage (..),
    Category (..),
    Finding (..),
    ProgramOutline (..),
    emptyOutline,
    enclosing,
  )
where

import Data.Maybe (listToMaybe)
import Data.Text (Text)
import Rosy.Worker.Problem (Function, Severity, Span (..))

-- | Category of a message, as far as GHC states it by a flag or code and not in prose.
data Category
  = -- | Syntax error.
    Syntax
  | -- | Type error or name resolution error.
    Types
  | -- | Typed hole, @_@ or @_name@.
    Hole
  | -- | Undefined name.
    Scope
  | -- | Missing cases.
    IncompletePatterns
  | -- | Unreachable case.
    OverlappingPatterns
  | -- | Tab character.
    Tabs
  | -- | Record construction without all fields.
    MissingFields
  | -- | Instance without all methods.
    MissingMethods
  | -- | Any other warning.
    Other
  deriving (Eq, Show)

-- | What GHC states as data, from GHC 9.6 on. Older versions state it in prose only, which "Rosy.Worker.Explanation" then reads. Types are
-- rendered as in a message.
data Finding
  = -- | The expected and the actual type.
    TypesDiffer Text Text
  | -- | A constraint that no instance satisfies, and the name or literal that it arises from, if it arises from one.
    InstanceMissing Text (Maybe Text)
  | -- | A type variable of which too little is known, the constraint on it, and the name or literal that the constraint arises from.
    VariableAmbiguous Text Text (Maybe Text)
  | -- | A qualified name whose module is not imported: the module.
    ModuleNotImported Text
  | -- | A type that is not in scope, while a data constructor of that name is.
    ConstructorAsType
  deriving (Eq, Show)

-- | One message. The three lists are the parts of GHC's document: the error, its context (innermost first), and hints.
data CompilerMessage = CompilerMessage
  { category :: Category,
    -- | The number of GHC's code for the message, from GHC 9.6 on; some messages have none.
    messageCode :: Maybe Int,
    finding :: Maybe Finding,
    messageSeverity :: Severity,
    messageSpan :: Maybe Span,
    important :: [Text],
    context :: [Text],
    supplementary :: [Text]
  }
  deriving (Eq, Show)

-- | Facts about the program that explanations use besides the messages.
data ProgramOutline = ProgramOutline
  { -- | Source text.
    text :: Text,
    -- | Top-level names with the spans of their definitions, in source order.
    bindings :: [(Text, Span)],
    -- | Top-level names with the spans of their type signatures.
    signatures :: [(Text, Span)],
    -- | The functions that the robot runs.
    connectedTo :: [Function],
    -- | The same functions in the same order, with type synonyms expanded.
    spelledOut :: [Function],
    -- | The types of the top-level names, as Haskell writes them.
    typesOfNames :: [(Text, Text)]
  }

emptyOutline :: Text -> ProgramOutline
emptyOutline source = ProgramOutline source [] [] [] [] []

-- | The top-level name whose definition or type signature holds a span.
enclosing :: ProgramOutline -> Span -> Maybe Text
enclosing outline s = listToMaybe [n | (n, within) <- bindings outline ++ signatures outline, start within <= start s, end s <= end within]
