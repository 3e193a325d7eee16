-- |
-- Module      : Ros.Names
-- Description : Names of nodes, topics and parameters, and the arguments that change them.
--
-- In: names as a program writes them and the command line of a node. Out: the names that other nodes
-- see. Pure; the rules are those of <http://wiki.ros.org/Names> and
-- <http://wiki.ros.org/Remapping%20Arguments>.
module Ros.Names
  ( -- * Names
    Name,
    Naming (..),
    resolve,
    nodeFullName,

    -- * Arguments
    Arguments (..),
    readArguments,
    special,
    remappings,
  )
where

import Control.Applicative ((<|>))
import Data.List (isPrefixOf)
import Data.Maybe (fromMaybe)

-- | Absolute when it starts with a slash, private to the node with a tilde, otherwise relative to the
-- namespace.
type Name = String

-- | What a name depends on.
data Naming = Naming
  { -- | of the node, absolute
    ownName :: Name,
    -- | absolute, @/@ at the least
    namespace :: Name,
    -- | both sides resolved
    remaps :: [(Name, Name)]
  }
  deriving (Eq, Show)

-- | The absolute name, after remapping.
resolve :: Naming -> Name -> Name
resolve naming n = fromMaybe absolute (lookup absolute (remaps naming))
  where
    absolute = absoluteName naming n

absoluteName :: Naming -> Name -> Name
absoluteName naming n = tidy $ case n of
  '/' : _ -> n
  '~' : rest -> ownName naming ++ "/" ++ rest
  _ -> namespace naming ++ "/" ++ n

-- | One slash at the front and between parts, none at the end.
tidy :: Name -> Name
tidy n = case filter (not . null) (parts n) of
  [] -> "/"
  ps -> concatMap ('/' :) ps
  where
    parts s = case break (== '/') s of
      (p, _ : rest) -> p : parts rest
      (p, []) -> [p]

-- | The node's name from what the program calls it, @__name@, @__ns@ and the environment's @ROS_NAMESPACE@.
nodeFullName :: Arguments -> Maybe String -> String -> Naming
nodeFullName args environment called = naming {remaps = map both (remappings args)}
  where
    ns = tidy ("/" ++ fromMaybe "" (special "__ns" args <|> environment))
    naming = Naming (tidy (at (fromMaybe called (special "__name" args)))) ns []
    at n = if "/" `isPrefixOf` n then n else ns ++ "/" ++ n
    both (from, to) = (absoluteName naming from, absoluteName naming to)

-- | The arguments of a node, sorted by what they do.
data Arguments = Arguments
  { -- | @a:=b@, @__name:=b@
    assignments :: [(String, String)],
    -- | @_rate:=5@ sets the parameter @~rate@; the underscore is gone
    privateParams :: [(String, String)],
    -- | the program's own
    plain :: [String]
  }
  deriving (Eq, Show)

readArguments :: [String] -> Arguments
readArguments = foldr sortIn (Arguments [] [] [])
  where
    sortIn a args = case split a of
      Just ('_' : key@(c : _), v) | c /= '_' -> args {privateParams = (key, v) : privateParams args}
      Just (key@(_ : _), v) -> args {assignments = (key, v) : assignments args}
      _ -> args {plain = a : plain args}
    split a = case breakOn a of
      (_, "") -> Nothing
      (key, rest) -> Just (key, drop 2 rest)
    breakOn s
      | null s || ":=" `isPrefixOf` s = ("", s)
      | otherwise = let (k, rest) = breakOn (drop 1 s) in (take 1 s ++ k, rest)

-- | The value of @__name@, @__ns@, @__master@, @__ip@ or @__hostname@.
special :: String -> Arguments -> Maybe String
special key = lookup key . assignments

remappings :: Arguments -> [(String, String)]
remappings = filter (not . ("__" `isPrefixOf`) . fst) . assignments
