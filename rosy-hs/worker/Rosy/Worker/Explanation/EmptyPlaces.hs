{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.EmptyPlaces
-- Description : Sentences about typed holes: what fits, and what a run says that comes to one.
--
-- GHC reports the type of a hole and the local names around it in prose only. Pure.
module Rosy.Worker.Explanation.EmptyPlaces
  ( whatFits,
    emptyPlaces,
  )
where

import Data.Char (isLower)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Problem (Position (..), Span (..))
import Rosy.Worker.Sentence

-- | The hint of a check: the type of the hole and the local names that fit.
whatFits :: CompilerMessage -> Sentence
whatFits raw = case wantedType raw of
  Nothing -> tr "Put a value in this place."
  Just t -> case take 3 [n | (n, u) <- atHand raw, u == t] of
    [] -> trWith "What fits is {a type}." ["type" =: t]
    fits -> trWith "What fits is {a type}, for example {or names}." ["type" =: t, "names" =* fits]

-- | The holes of a program: start and end, and message and hint of a run that comes to it, as 'portable' sentences.
emptyPlaces :: ProgramOutline -> [CompilerMessage] -> [((Int, Int), (Int, Int), String, String)]
emptyPlaces outline raws =
  [ (position (start s), position (end s), portable (cameTo (name s) (enclosing outline s) (line (start s))), portable (hint raw))
    | raw <- raws,
      category raw == Hole,
      Just s <- [messageSpan raw]
  ]
  where
    position p = (line p, column p)
    -- A plain _ has no name.
    name s = case snippet (text outline) s of
      Just written | written /= "_" -> Just written
      _ -> Nothing
    hint raw = needs (wantedType raw) [quoted (n <> " :: " <> t) | (n, t) <- atHand raw, n `notElem` map fst (bindings outline)]

-- | What a run says that comes to a hole with this name, in this definition and line.
cameTo :: Maybe Text -> Maybe Text -> Int -> Sentence
cameTo name definition at = case (name, definition) of
  (Nothing, Nothing) -> trWith "The run came to the empty place (line {line})." ["line" =# at]
  (Just n, Nothing) -> trWith "The run came to the empty place ‘{name}’ (line {line})." ["name" =: n, "line" =# at]
  (Nothing, Just d) -> trWith "The run came to the empty place in ‘{definition}’ (line {line})." ["definition" =: d, "line" =# at]
  (Just n, Just d) -> trWith "The run came to the empty place ‘{name}’ in ‘{definition}’ (line {line})." ["name" =: n, "definition" =: d, "line" =# at]

-- | The type that a hole needs, and the local names with their types.
needs :: Maybe Type -> [Text] -> Sentence
needs wanted local = case (wanted, local) of
  (Nothing, []) -> tr "It needs a value."
  (Just t, []) -> trWith "It needs {a type}." ["type" =: t]
  (Nothing, _) -> trWith "It needs a value; you have {names}." ["names" =* local]
  (Just t, _) -> trWith "It needs {a type}; you have {names}." ["type" =: t, "names" =* local]

-- | The type that GHC found for a hole; nothing when it is not known.
wantedType :: CompilerMessage -> Maybe Type
wantedType raw = case between "::" "Where:" (fst (Text.breakOn " Or perhaps ‘" (oneLine (Text.unwords (important raw))))) of
  -- A variable is a type that is not known.
  Just wanted | Text.length wanted > 2, not (Text.all isLower (Text.take 1 wanted)) -> Just (simplifyType wanted)
  _ -> Nothing

-- | The names around a hole that GHC lists, with their types.
atHand :: CompilerMessage -> [(Text, Type)]
atHand raw = maybe [] entries (after "Relevant bindings include" (oneLine (Text.unwords (important raw ++ context raw ++ supplementary raw))))
  where
    entries t = case Text.breakOn " :: " t of
      (_, rest) | Text.null rest -> []
      (before, rest) ->
        let (type', more) = Text.breakOn " (bound at" (Text.drop 4 rest)
         in (fromMaybe "" (listToMaybe (reverse (Text.words before))), simplifyType type') : entries (Text.drop 1 (Text.dropWhile (/= ')') more))
