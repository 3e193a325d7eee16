{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TypeMessages
-- Description : What a message about types states, and where a type stands in the program.
--
-- Reads the types, classes and names from GHC's data where it states them ('finding'), or else from its prose. Pure.
module Rosy.Worker.Explanation.TypeMessages
  ( -- * What a message states
    Say,
    ambiguityIn,
    missingInstanceIn,
    mismatchIn,

    -- * Types as text
    firstAtom,
    inner,
    isVariable,
    stripBrackets,
    bracketIfNeeded,

    -- * Places in the program
    typePlace,
    lineAt,
  )
where

import Data.Char (isLower)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Makes the problem of a message from its kind, its sentence and its hint.
type Say = Text -> Sentence -> Sentence -> Problem

-- * What a message states

-- | Expected and actual type. Takes the message's text on one line.
mismatchIn :: CompilerMessage -> Text -> Maybe (Type, Type)
mismatchIn raw messageText = case finding raw of
  Just (TypesDiffer needed given) -> Just (simplifyType needed, simplifyType given)
  Just _ -> Nothing
  Nothing -> mismatch messageText

-- | Class, type, and the expression that requires it.
missingInstanceIn :: CompilerMessage -> Text -> Maybe (Text, Type, Text)
missingInstanceIn raw messageText = case finding raw of
  Just (InstanceMissing constraint user) -> Just (classOf constraint, simplifyType (stripBrackets (Text.strip (Text.drop 1 (snd (Text.breakOn " " (oneLine constraint)))))), maybe (userIn messageText) withoutGeneratedNames user)
  Just _ -> Nothing
  Nothing -> noInstance messageText

-- | Type variable, class, and the expression that requires it.
ambiguityIn :: CompilerMessage -> Text -> Maybe (Text, Text, Text)
ambiguityIn raw messageText = case finding raw of
  Just (VariableAmbiguous v constraint user) -> Just (v, classOf constraint, maybe (userIn messageText) withoutGeneratedNames user)
  Just _ -> Nothing
  Nothing -> ambiguous messageText

classOf :: Text -> Text
classOf = Text.takeWhile (/= ' ') . oneLine

-- * Prose of messages

mismatch :: Text -> Maybe (Type, Type)
mismatch messageText
  | Just rest <- after "Expected:" messageText,
    "Couldn't match" `Text.isPrefixOf` messageText =
    let (needed, more) = Text.breakOn "Actual:" rest
     in Just (typeIn needed, typeIn (upToNote (Text.drop 7 more)))
  | Just rest <- after "Couldn't match expected type" messageText =
    let (needed, more) = Text.breakOn "with actual type" rest
     in Just (typeIn (colon needed), typeIn (upToNote (colon (Text.drop 16 more))))
  | Just rest <- after "Couldn't match type" messageText,
    needed : given : _ <- quotedParts rest =
    Just (simplifyType needed, simplifyType given)
  | otherwise = Nothing
  where
    colon t = Text.strip (fromMaybe t (Text.stripPrefix ":" (Text.strip t)))
    upToNote t = foldr (\mark x -> fst (Text.breakOn mark x)) t ["‘’", " arising from", " Type synonyms", " The type variable", " because type"]

noInstance :: Text -> Maybe (Text, Type, Text)
noInstance messageText = do
  rest <- after "No instance for (" messageText
  let inside = bracketed rest
      (c, t) = Text.breakOn " " inside
  Just (c, simplifyType (stripBrackets (Text.strip t)), userIn messageText)

-- | The expression that a constraint arises from.
userIn :: Text -> Text
userIn messageText = maybe "" (\x -> fromMaybe (Text.takeWhile (/= ' ') x) (listToMaybe (quotedParts x))) (after "arising from" messageText)

bracketed :: Text -> Text
bracketed = go (0 :: Int) ""
  where
    go depth acc rest = case Text.uncons rest of
      Just (')', _) | depth == 0 -> acc
      Just (x, more)
        | x `elem` ("([" :: String) -> go (depth + 1) (Text.snoc acc x) more
        | x `elem` (")]" :: String) -> go (depth - 1) (Text.snoc acc x) more
        | otherwise -> go depth (Text.snoc acc x) more
      Nothing -> acc

ambiguous :: Text -> Maybe (Text, Text, Text)
ambiguous messageText = do
  rest <- after "Ambiguous type variable" messageText
  let names = quotedParts rest
      v = fromMaybe "" (listToMaybe names)
      c = maybe "" (Text.takeWhile (/= ' ')) (after "the constraint ‘(" rest)
      user = fromMaybe "" (listToMaybe (drop 1 names))
  Just (v, c, user)

-- * Types as text

-- | The constructor of a type, without its arguments.
firstAtom :: Type -> Type
firstAtom = fromMaybe "" . listToMaybe . typeAtoms

-- | The arguments of a type, without its constructor.
inner :: Type -> Type
inner t = Text.unwords (drop 1 (typeAtoms t))

-- | Whether a type is a type variable.
isVariable :: Type -> Bool
isVariable t = maybe False (isLower . fst) (Text.uncons t) && not (Text.any (== ' ') t)

-- | Without brackets around the whole; a tuple keeps them.
stripBrackets :: Text -> Text
stripBrackets t = case Text.stripPrefix "(" t >>= Text.stripSuffix ")" of
  Just within | within == bracketed within, "," `notElemOuter` within, not (Text.null within) -> within
  _ -> t
  where
    notElemOuter c x = not (c `Text.isInfixOf` x)

bracketIfNeeded :: Type -> Type
bracketIfNeeded t = if length (typeAtoms t) > 1 then "(" <> t <> ")" else t

-- * Places in the program

-- | Where a type is written in the signature of a function.
typePlace :: ProgramOutline -> Text -> Type -> Maybe Span
typePlace outline name t = do
  s <- lookup name (signatures outline)
  l <- listToMaybe (drop (line (start s) - 1) (Text.splitOn "\n" (text outline)))
  let signature = if line (start s) == line (end s) then Text.take (column (end s) - 1) l else l
      (before, rest) = Text.breakOn "::" signature
      (more, found) = Text.breakOn t rest
      from = Text.length before + Text.length more + 1
  if Text.null found then Nothing else Just (Span (start s) {column = from} (start s) {column = from + Text.length t})

-- | The line of the program on which a span begins.
lineAt :: ProgramOutline -> Span -> Text
lineAt outline s = lineOf (text outline) (line (start s))
