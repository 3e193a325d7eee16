{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.MismatchRepairs
-- Description : Type mismatches that are repaired at another place than GHC names.
--
-- GHC names a whole sum, one part of a list, or the task whose end is used; the repair belongs to a name in it, to the brackets around it, or to
-- a later use.
module Rosy.Worker.Explanation.MismatchRepairs
  ( endUsedElsewhere,
    listOfDifferentTypes,
    wholeNumbers,
  )
where

import Control.Monad (guard)
import Data.Char (isAlphaNum, isDigit, isLower)
import Data.List (tails)
import Data.Maybe (listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.RobotVocabulary (conversionHint, isNumber)
import Rosy.Worker.Explanation.TextRepair (edited)
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | A sum or product of names and numbers on one line that is an Int where a Double is needed: all its parts have one type, so each name is an Int.
wholeNumbers :: ProgramOutline -> CompilerMessage -> (Text -> Sentence -> Sentence -> Problem) -> Maybe Problem
wholeNumbers outline raw problem = do
  s <- messageSpan raw
  let inside = [t | t <- tokenize (text outline), start s <= from t, from t < end s]
      isOperator t = word t `elem` ["+", "-", "*", "/"]
      isLiteral t = Text.all isDigit (word t)
      isNamed t = beginsSmall t && Text.all isAlphaNum (word t) && word t `notElem` ["if", "case", "let", "do"]
      isValue t = isNamed t || isLiteral t
      isPart t = isValue t || isOperator t || word t `elem` ["(", ")", "."]
      isApplied = or [isValue a && isValue b | (a, b) <- zip inside (drop 1 inside)]
      names = filter isNamed inside
      converted t = "fromIntegral " <> word t
      repair = [Edit (tokenSpan t) (converted t) | t <- names]
      widened = sum [Text.length (converted t) - Text.length (word t) | t <- names]
  n <- listToMaybe names
  guard (any isOperator inside && all isPart inside && not isApplied && length (filter isValue inside) > 1 && line (start s) == line (end s))
  let whole = textAt (edited repair (text outline)) s {end = (end s) {column = column (end s) + widened}}
  Just (problem "type-mismatch" (trWith "‘{name}’ is {a given}, a whole number, but {a needed} is needed." ["name" =: word n, "given" =: "Int", "needed" =: "Double"]) (trWith "Write: {code}" ["code" =: Text.strip whole])) {place = Just (tokenSpan n), fixes = [Fix (trWith "Write {code}" ["code" =: converted n]) repair]}

-- | A part of a list on one line. The brackets are mended if the list is all that simulate is given.
listOfDifferentTypes :: ProgramOutline -> CompilerMessage -> (Text -> Sentence -> Sentence -> Problem) -> Maybe Problem
listOfDifferentTypes outline raw problem = do
  s <- messageSpan raw
  let row = [t | t <- tokenize (text outline), line (from t) == line (start s)]
      (before, behind) = span ((< start s) . from) row
      opening = ["(", "["]
      closing = [")", "]"]
  (o, outer) <- unmatched opening closing (reverse before)
  (c, _) <- unmatched closing opening (dropWhile ((< end s) . from) behind)
  guard (word o == "[" && word c == "]")
  let code = "(" <> Text.strip (textAt (text outline) (Span (tokenEnd o) (from c))) <> ")"
  Just (problem "type-mismatch" (tr "The parts of a list have one type, and these differ.") (trWith "Put functions of different types into round brackets: {code}" ["code" =: code])) {fixes = [Fix (trWith "Write {code}" ["code" =: code]) [Edit (tokenSpan o) "(", Edit (tokenSpan c) ")"] | take 1 (map word outer) == ["simulate"]]}

-- | The first of these brackets that none of the others before it belongs to, and what comes behind it.
unmatched :: [Text] -> [Text] -> [Token] -> Maybe (Token, [Token])
unmatched these others = go (0 :: Int)
  where
    go n ts = case ts of
      t : rest
        | n == 0, word t `elem` these -> Just (t, rest)
        | word t `elem` these -> go (n - 1) rest
        | word t `elem` others -> go (n + 1) rest
        | otherwise -> go n rest
      [] -> Nothing

-- | As in @n <- task () f@, where what follows needs another type than the task ends with: the first use of the name in the same definition that does.
endUsedElsewhere :: ProgramOutline -> CompilerMessage -> (Text -> Sentence -> Sentence -> Problem) -> Type -> Type -> Maybe Problem
endUsedElsewhere outline raw problem needed given = do
  s <- messageSpan raw
  (n, a) <- listToMaybe [(n, a) | n : a : _ <- tails [t | t <- tokenize (text outline), line (from t) == line (start s)], word a == "<-", from a < start s, beginsSmall n]
  let definition = listToMaybe [b | (_, b) <- bindings outline, start b <= start s, end s <= end b]
      later = [t | t <- tokenize (text outline), line (from t) > line (from a), maybe False ((> from t) . end) definition]
      uses = [(b, t) | (b, t) <- zip (n : later) later, word t == word n]
      isSaid (b, _) = word b == "say"
      isAgain = or [word x `elem` ["<-", "="] && word t == word n | t : x : _ <- tails later]
      isShowable = given `elem` ["Int", "Integer", "Double", "Float", "Bool"]
      shown = "(show " <> word n <> ")"
      carried = trWith "‘{name}’ is {a given}, which its Done carries, but what follows needs {a needed}." ["name" =: word n, "given" =: given, "needed" =: needed]
      hintFor found = case found of
        [(b, t)] | (given, needed) == ("Int", "Double"), beginsSmall b -> trWith "Write: {code}" ["code" =: (word b <> " (fromIntegral " <> word t <> ")")]
        _ | isNumber given && isNumber needed -> conversionHint needed given
        _ -> tr "Make both the same type."
  Just $ case filter isSaid uses of
    (_, t) : _
      | needed == "String",
        not isAgain ->
        (problem "done-type" (trWith "‘say’ takes a text, but ‘{name}’ is {a given}." ["name" =: word n, "given" =: given]) (if isShowable then trWith "Write: {code}" ["code" =: ("say " <> shown)] else tr "Turn it into a text first.")) {place = Just (tokenSpan t), fixes = [Fix (trWith "Write {code}" ["code" =: shown]) [Edit (tokenSpan u) shown | (_, u) <- uses] | isShowable, all isSaid uses]}
    _ -> (problem "done-type" carried (hintFor uses)) {place = Just (case uses of [(_, t)] | not isAgain -> tokenSpan t; _ -> tokenSpan n)}

beginsSmall :: Token -> Bool
beginsSmall = maybe False (isLower . fst) . Text.uncons . word
