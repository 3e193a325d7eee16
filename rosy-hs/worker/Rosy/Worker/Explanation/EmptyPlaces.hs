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

-- | The holes of a program: start and end, and message and hint of a run that comes to one.
emptyPlaces :: ProgramOutline -> [CompilerMessage] -> [((Int, Int), (Int, Int), String, String)]
emptyPlaces outline raws =
  [ (position (start s), position (end s), Text.unpack (message s), Text.unpack (hint raw))
    | raw <- raws,
      category raw == Hole,
      Just s <- [messageSpan raw]
  ]
  where
    position p = (line p, column p)
    message s = "The run came to the empty place" <> name s <> maybe "" ((" in " <>) . quoted) (enclosing outline s) <> " (line " <> Text.pack (show (line (start s))) <> ")."
    -- A plain _ has no name.
    name s = case snippet (text outline) s of
      Just written | written /= "_" -> " " <> quoted written
      _ -> ""
    hint raw = needs raw <> has raw
    needs raw = maybe "It needs a value" (("It needs " <>) . withArticle) (wantedType raw)
    has raw = case [quoted (n <> " :: " <> t) | (n, t) <- atHand raw, n `notElem` map fst (bindings outline)] of
      [] -> "."
      local -> "; you have " <> Text.intercalate ", " local <> "."

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
