-- |
-- Module      : Rosy.Model.Default
-- Description : Model of defaults: the value that a memory holds before its first write (rule R7).
--
-- A type is a name, a declaration lists its constructors in order. The default of a type is the first constructor whose fields have
-- defaults; the search for a field's default may not come back to a type that is being searched, because that value would be infinite.
module Rosy.Model.Default
  ( Declarations,
    Built (..),
    defaultOf,
  )
where

import Data.Maybe (listToMaybe)

-- | The constructors of a type in order, each with the types of its fields.
type Declarations = String -> [(String, [String])]

-- | A constructor with its fields.
data Built = Built String [Built]
  deriving (Eq, Show)

-- | The default of a type; 'Nothing' if the type has no finite value.
--
-- >>> let stack t = [("Push", ["Int", "Stack"]) | t == "Stack"] ++ [("Empty", []) | t == "Stack"] ++ [("0", []) | t == "Int"]
-- >>> defaultOf stack "Stack"
-- Just (Built "Empty" [])
defaultOf :: Declarations -> String -> Maybe Built
defaultOf declared = search []
  where
    search pending t
      | t `elem` pending = Nothing
      | otherwise = listToMaybe [Built c fields | (c, ts) <- declared t, Just fields <- [mapM (search (t : pending)) ts]]
