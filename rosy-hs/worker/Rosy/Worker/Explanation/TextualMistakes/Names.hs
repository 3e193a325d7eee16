{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TextualMistakes.Names
-- Description : Names with a capital letter in place of a small one or the other way round, and patterns of the robot's types.
module Rosy.Worker.Explanation.TextualMistakes.Names
  ( capitals,
    smallLetters,
    patterns,
    namesInParts,
  )
where

import Data.Char (isDigit)
import Data.List (tails)
import Data.Maybe (isJust, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText (lineOf, textAt)
import Rosy.Worker.Explanation.RobotVocabulary
import Rosy.Worker.Explanation.TextRepair
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Words that declare a type.
typeKeywords :: [Text]
typeKeywords = ["data", "newtype", "type"]

-- | Functions whose name begins with a capital letter, where they are named first.
capitals :: Program -> [Problem]
capitals p =
  [ repaired p (tokenSpan f) "capital" (tr "The name of a function begins with a small letter.") (renamings f)
    | (before, row@(f : _)) <- zip (scanl (flip (:)) [] (rows p)) (rows p),
      column (from f) == 1,
      isConstructor (word f),
      word f `notElem` known,
      any ((`elem` ["::", "="]) . word) (drop 1 row),
      all ((`notElem` ["<-", "|", "{"]) . word) row,
      word f `notElem` [word g | g : _ <- before]
  ]
  where
    renamings f = [Edit (tokenSpan t) (uncapitalised (word f)) | uncapitalised (word f) `notElem` map word (tokens p), t <- tokens p, word t == word f]
    uncapitalised w = Text.toLower (Text.take 1 w) <> Text.drop 1 w
    known = robotNames ++ ["Just", "Left", "Right", "Memory", "Double", "Int", "Bool", "String"] ++ declared
    declared = concat [map word row | row@(d : _) <- rows p, word d `elem` typeKeywords]

-- | Types and constructors of the robot that begin with a small letter.
smallLetters :: Program -> [Problem]
smallLetters p = concatMap inSignature (rows p) ++ concatMap inPatterns (rows p) ++ concatMap inDeclaration (rows p)
  where
    inSignature row = case break ((== "::") . word) row of
      ([_], _ : types) -> corrected typeIsCapital (filter isMisspelt types)
      _ -> []
    -- A pattern in brackets that begins with the name of a type.
    inPatterns row = case break ((`elem` ["=", "->", "|"]) . word) row of
      (left, _ : _)
        | all ((`notElem` ["::", "if", "case", "let"]) . word) left ->
          concat
            [ corrected (tr "The values of a type begin with a capital letter.") (filter isMisspelt (takeWhile ((/= ")") . word) inside))
              | o : inside@(c : _) <- tails left,
                word o == "(",
                isMisspelt c,
                isJust (valueSyntaxHint (capitalised (word c)))
            ]
      _ -> []
    inDeclaration row = case row of
      d : t : _
        | word d `elem` typeKeywords,
          isName (word t),
          word t `notElem` ["family", "instance"] ->
          [repaired p (tokenSpan t) "capital" typeIsCapital [Edit (tokenSpan w) (capitalised (word t)) | w <- tokens p, word w == word t]]
      _ -> []
    isMisspelt t = isName (word t) && capitalised (word t) `elem` robotNames
    typeIsCapital = tr "The name of a type begins with a capital letter."
    corrected message' wrong = [repaired p (tokenSpan t) "capital" message' [Edit (tokenSpan w) (capitalised (word w)) | w <- wrong] | t : _ <- [wrong]]

-- | Patterns of the robot's types with parts that are missing, in another order, or have another name.
patterns :: Program -> [Problem]
patterns p = concatMap patternAt (tails (tokens p)) ++ concatMap (withoutBrackets p) (rows p)
  where
    patternAt ts = concat (take 1 (filter (not . null) [anyInComparison p ts, partOfPattern p ts, inBrackets p ts, behindDot p ts]))

-- | The constructors with a place and a state.
hasPlaceAndState :: Token -> Bool
hasPlaceAndState t = word t `elem` eventsWithPlaces

isState :: Token -> Bool
isState t = word t `elem` ["Pressed", "Released", "Hole", "Floor", "Air", "Ground"]

isPlace :: Token -> Bool
isPlace t = word t `elem` places

-- | A word for anything in a comparison: @bumper == Bumper any Pressed@. Takes the tokens from the sign or from the value on.
anyInComparison :: Program -> [Token] -> [Problem]
anyInComparison p ts = case ts of
  e : o : c : a : b : z : _ | isComparison e, word o == "(", word z == ")" -> compared (spanOf o z) e c a b
  o : c : a : b : z : e : _ | isComparison e, word o == "(", word z == ")" -> compared (spanOf o z) e c a b
  e : c : a : b : _ | isComparison e -> compared (spanOf c b) e c a b
  c : a : b : e : _ | isComparison e -> compared (spanOf c b) e c a b
  _ -> []
  where
    isComparison t = word t `elem` ["==", "/="]
    isAnything t = word t `elem` ["_", "any", "Any", "all", "All", "*"]
    compared s e c a b =
      [ case equationsInstead p e [c, a, b] (inPattern [c, a, b]) of
          Just (repair, first, second) -> repairedWith p s "pattern" (message' t) (trWith "Only a pattern can leave a part open: _ stands there. Write: {code}, and below it: {other}" ["code" =: first, "other" =: second]) [repair]
          Nothing -> repairedWith p s "pattern" (message' t) (trWith "Only a pattern can leave a part open: _ stands there, for example: {code}" ["code" =: ("f (" <> inPattern [c, a, b] <> ") = …")]) []
        | hasPlaceAndState c,
          t : _ <- [filter isAnything [a, b]]
      ]
    inPattern = Text.unwords . map (\t -> if isAnything t then "_" else word t)
    message' t = trWith "‘{word}’ does not work in a comparison." ["word" =: word t]

-- | A definition whose only condition compares a parameter with a value, as two equations with a pattern: the repair, and both of them. Takes the
-- sign of the comparison, the value and the pattern.
equationsInstead :: Program -> Token -> [Token] -> Text -> Maybe (Edit, Text, Text)
equationsInstead p e value pattern' = case [t | t <- tokens p, chunkOf p (line (from t)) == chunkOf p (line (from e))] of
  whole@(f : _)
    | column (from f) == 1,
      isName (word f),
      (parameters@(_ : _), separator : body) <- break ((`elem` ["=", "|"]) . word) (drop 1 whole),
      Just (condition, (x, afterX), y) <- branches (word separator) body,
      [v] <- [t | t <- parameters, isCompared condition t, isAlone parameters t],
      all isPlain [x, y],
      onOneLine x,
      onOneLine y,
      let lastLine = line (from (last y)),
      let wholeSpan = Span (from f) (Position lastLine (Text.length (lineOf (source p) lastLine) + 1)),
      not (any (`Text.isInfixOf` textAt (source p) wholeSpan) ["--", "{-"]),
      let written = Text.strip . textAt (source p),
      let valueX = (x, written (Span (from (head' x)) (from afterX))),
      let valueY = (y, written (Span (from (head' y)) (end wholeSpan))),
      ((matched, first'), (others, second')) <- if word e == "==" then (valueX, valueY) else (valueY, valueX),
      let equation new t = textAt (source p) (Span (from f) (from v)) <> new <> textAt (source p) (Span (tokenEnd v) (tokenEnd (last parameters))) <> " = " <> t,
      let first = equation ((if names v matched then word v <> "@" else "") <> "(" <> pattern' <> ")") first',
      let second = equation (if names v others then word v else "_") second' ->
      Just (Edit wholeSpan (first <> "\n" <> second), first, second)
  _ -> Nothing
  where
    branches "=" (i : rest)
      | word i == "if",
        (condition, _ : more) <- break ((== "then") . word) rest,
        (x, afterX : y) <- break ((== "else") . word) more =
        Just (condition, (x, afterX), y)
    branches "|" rest
      | (condition, _ : more) <- break ((== "=") . word) rest,
        (x, afterX : o : q : y) <- break ((== "|") . word) more,
        map word [o, q] == ["otherwise", "="] =
        Just (condition, (x, afterX), y)
    branches _ _ = Nothing
    isCompared condition t = filter (`notElem` ["(", ")"]) (map word condition) `elem` [word t : word e : map word value, map word value ++ [word e, word t]]
    -- Outside of brackets.
    isAlone parameters t = let before = map word (takeWhile (/= t) parameters) in isName (word t) && length (filter (== "(") before) == length (filter (== ")") before) && "@" `notElem` before
    isPlain ts = not (null ts) && not (any ((`elem` ["if", "then", "else", "|", "=", "where", "let", "do", "case", ";"]) . word) ts)
    onOneLine ts = all ((== line (from (head' ts))) . line . from) ts
    names v = any ((== word v) . word)
    head' = foldr const e

-- | Other words for anything, parts in the wrong order, and other names of places. Takes the tokens from a constructor on.
partOfPattern :: Program -> [Token] -> [Problem]
partOfPattern p ts = case ts of
  c : a : b : _
    | not (hasPlaceAndState c) -> []
    | isAnything a -> [anything a]
    | isAnything b -> [anything b]
    | isState a,
      isPlace b ->
      [repaired p (spanOf a b) "pattern" (trWith "The two parts of ‘{name}’ are in the wrong order." ["name" =: word c]) [Edit (tokenSpan a) (word b), Edit (tokenSpan b) (word a)]]
    | Just hint' <- valueSyntaxHint (word c <> "Side"),
      let place' = capitalised (Text.toLower (word a)) <> word c,
      place' `elem` places ->
      [(repaired p (tokenSpan a) "not-in-scope" (trWith "The sides of ‘{name}’ have other names." ["name" =: word c]) [Edit (tokenSpan a) place']) {hint = hint'}]
  _ -> []
  where
    isAnything t = word t `elem` ["Any", "All", "*"]
    anything t = repaired p (tokenSpan t) "pattern" (tr "In a pattern, _ stands for anything.") [Edit (tokenSpan t) "_"]

-- | One part in place of two, and commas between the parts. Takes the tokens from an opening bracket on.
inBrackets :: Program -> [Token] -> [Problem]
inBrackets p ts = case ts of
  o : c : a : z : more
    | isPattern o c,
      word z == ")",
      isState a || isPlace a,
      fmap word (listToMaybe more) /= Just "==" ->
      [repaired p (spanOf o z) "pattern-arguments" (oneOfTwo c) [if isState a then Edit (nothingAt (from a)) "_ " else Edit (nothingAt (tokenEnd a)) " _"]]
  o : c : m : a : z : more
    | isPattern o c, word m == ",", isState a, word z == ")" -> [repaired p (spanOf o z) "pattern" (twoParts c) [Edit (Span (from m) (from a)) " _ "]]
    | isPattern o c, word m == ",", word z == ",", b : _ <- more -> [repaired p (spanOf o b) "pattern" withoutCommas [Edit (Span (from m) (from a)) " ", Edit (Span (from z) (from b)) " "]]
  _ -> []
  where
    isPattern o c = word o == "(" && hasPlaceAndState c
    oneOfTwo c = trWith "‘{name}’ holds {count wanted} values, but here one is named." ["name" =: word c, "wanted" =# 2]
    twoParts c = trWith "‘{name}’ has two parts with no comma between them, and the first is missing: _ stands for any." ["name" =: word c]
    withoutCommas = tr "The parts of a pattern follow its name without commas."

-- | A pattern with two parts on the left of a definition.
withoutBrackets :: Program -> [Token] -> [Problem]
withoutBrackets p row = case row of
  f : c : a : b : e : _
    | column (from f) == 1,
      isName (word f),
      hasPlaceAndState c || word c `elem` ["Velocity", "Position"],
      word e `elem` ["=", "|"],
      all (isOperand . word) [a, b],
      "(" `notElem` map word [a, b] ->
      [repaired p (spanOf c b) "argument-count" (tr "A pattern with several parts needs brackets.") [Edit (nothingAt (from c)) "(", Edit (nothingAt (tokenEnd b)) ")"]]
  _ -> []

-- | A part of a value behind a dot: @Bumper.Pressed@, @Led1.Green@, @LedColor.Red@. Takes the tokens from the one in front on.
behindDot :: Program -> [Token] -> [Problem]
behindDot p ts = case ts of
  o : c : d : v : z : _
    | word d == ".",
      isGlued c d,
      isGlued d v,
      Just (message', whole) <- written c v ->
      let isBracketed = map word [o, z] == ["(", ")"] || " " `notElem'` whole
       in [repaired p (spanOf c v) "pattern" message' [Edit (spanOf c v) (if isBracketed then whole else "(" <> whole <> ")")]]
  _ -> []
  where
    notElem' x t = not (x `Text.isInfixOf` t)
    written c v
      | hasPlaceAndState c, isState v = Just (ofParts, word c <> " _ " <> word v)
      | hasPlaceAndState c, isPlace v = Just (ofParts, word c <> " " <> word v <> " _")
      | word c `elem` ["Led1", "Led2"], isConstructor (word v) = Just (ofParts, word c <> " " <> word v)
      | word c `elem` ["LedColor", "Sound", "ButtonNumber"] || any (`Text.isSuffixOf` word c) ["Side", "Status"], word v `elem` robotNames = Just (trWith "‘{name}’ stands alone, without its type in front." ["name" =: word v], word v)
      | otherwise = Nothing
    ofParts = tr "The parts of a value follow its name without a dot."

-- | Names of several parts, and names that begin with a digit, where they are defined: @my-speed = 1@, @my speed = 1@, @2fast = 1@.
namesInParts :: Program -> [Problem]
namesInParts p = take 1 (concatMap named [row | row@(f : _) <- rows p, column (from f) == 1])
  where
    named row = case row of
      f : e : _
        | (digits, letters) <- Text.span isDigit (word f),
          not (Text.null digits || Text.null letters),
          isName letters,
          word e `elem` ["=", "::"],
          isNew (letters <> digits) ->
          [repaired p (tokenSpan f) "name" (tr "A name begins with a letter.") [Edit (tokenSpan t) (letters <> digits) | t <- tokens p, word t == word f]]
      f : h : _
        | word h == "-",
          isGlued f h,
          (parts@(_ : _), e : _) <- hyphened row,
          word e `elem` ["=", "::"] || isName (word e),
          isName (word f),
          let new = joinedName (map word parts),
          isNew new ->
          [repaired p (spanOf f (last parts)) "name" (tr "A name has no hyphen in it.") [Edit (spanOf x (last xs)) new | (x, xs) <- occurrences (map word parts)]]
      f : n : e : value
        | isName (word f) && isName (word n) && word e == "=",
          word f `notElem` ["type", "data", "newtype", "let", "where", "infix"] ++ variableWords,
          word n `notElem` map word value,
          let places' = [(x, y) | (x, y) <- zip (tokens p) (drop 1 (tokens p)), map word [x, y] == map word [f, n]],
          length places' > 1,
          length places' == length (filter ((== word n) . word) (tokens p)),
          length places' == length (filter ((== word f) . word) (tokens p)),
          let new = joinedName (map word [f, n]),
          isNew new ->
          [repaired p (spanOf f n) "name" (tr "A name is one word.") [Edit (spanOf x y) new | (x, y) <- places']]
      _ -> []
    isNew new = new `notElem` map word (tokens p)
    joinedName ws = Text.concat (take 1 ws ++ map capitalised (drop 1 ws))
    -- The parts of a name with hyphens, and what follows.
    hyphened ts = case ts of
      a : h : b : more | word h == "-", isGlued a h, isGlued h b, isName (word b) -> let (parts, rest) = hyphened (b : more) in (a : parts, rest)
      a : rest -> ([a], rest)
      [] -> ([], [])
    occurrences ws = [(x, xs) | rest@(x : _) <- tails (tokens p), let (xs, _) = hyphened rest, map word xs == ws]
    variableWords = ["var", "const", "val", "def", "int", "double", "float", "bool", "function", "func", "fun"]
