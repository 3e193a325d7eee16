{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TextualMistakes.Conditions
-- Description : Guards, cases, conditions and lambda expressions with signs and words of other languages.
module Rosy.Worker.Explanation.TextualMistakes.Conditions
  ( guards,
    lastCases,
    conditions,
    lambdas,
  )
where

import Data.List (nub, tails)
import Data.Maybe (listToMaybe)
import Data.Text (Text)
import Rosy.Worker.Explanation.MessageText (textAt)
import Rosy.Worker.Explanation.TextRepair
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Guards with other signs than one bar, without one, and with @if@.
guards :: Program -> [Problem]
guards p = concatMap (withoutBars p) (tails (rows p)) ++ doubleBars p ++ concatMap (ifBehindBar p) (rows p) ++ arrowsBehindGuards p

-- | Conditions in the lines below the head of a function. Takes the rows from the head on.
withoutBars :: Program -> [[Token]] -> [Problem]
withoutBars p rest = case rest of
  header@(f : _) : more
    | column (from f) == 1,
      isName (word f),
      all ((`notElem` ["=", "|", "::", "do", "where", "of", "data", "type"]) . word) header,
      bars@((t : _) : _) <- takeWhile isBare more,
      let isOtherSign g = looksLikeBar g && word g `notElem` map word header,
      let barred = [if isOtherSign g then Edit (tokenSpan g) "|" else Edit (nothingAt (from g)) "| " | g : _ <- bars] ->
      [repaired p (tokenSpan t) "guard" (if isOtherSign t then trWith "A condition has a bar | in front, not ‘{sign}’." ["sign" =: word t] else tr "A bar is missing in front of each condition.") barred]
  _ -> []
  where
    isBare row = case break ((== "=") . word) row of
      (g : condition, _ : _ : _) -> column (from g) > 1 && word g `notElem` ["|", "||"] && (word g == "otherwise" || looksLikeBar g && map word (take 1 condition) == ["otherwise"] || any isComparison condition)
      _ -> False
    -- Letters and signs that are taken for the bar.
    looksLikeBar g = word g `elem` ["l", "I", "¦", "/", "\\"]
    isComparison t = word t `elem` ["==", "/=", "<", ">", "<=", ">="]

doubleBars :: Program -> [Problem]
doubleBars p =
  [ repaired p (tokenSpan t) "guard" (tr "A condition has a single bar in front.") [Edit (tokenSpan b) "|" | b : _ <- doubled]
    | (t : _) : _ <- [filter (any ((== "=") . word)) doubled]
  ]
  where
    doubled = [row | row@(b : _) <- rows p, word b == "||"]

ifBehindBar :: Program -> [Token] -> [Problem]
ifBehindBar p row = case row of
  b : i : n : more
    | word b == "|",
      word i == "if",
      "then" `notElem` map word more ->
      [repaired p (tokenSpan i) "guard" (tr "After a bar, a condition is written without ‘if’.") [Edit (Span (from i) (from n)) ""]]
  _ -> []

-- | Guards of a function with arrows in place of equals signs: one problem for each definition.
arrowsBehindGuards :: Program -> [Problem]
arrowsBehindGuards p =
  [ repaired p (tokenSpan t) "missing-equals" (tr "An equals sign goes between a guard and its value.") [Edit (tokenSpan x) "=" | x <- arrows]
    | n <- nub [chunkOf p (line (from b)) | b : _ <- guardRows (rows p)],
      let definition = [row | row@(b : _) <- rows p, chunkOf p (line (from b)) == n],
      all ((`notElem` ["case", "\\", "data", "of", "if"]) . word) (concat definition),
      let arrows = [x | row <- guardRows definition, "=" `notElem` map word row, x <- take 1 (filter ((== "->") . word) row)],
      t : _ <- [arrows]
  ]
  where
    guardRows rs = [row | row@(b : _) <- rs, word b == "|"]

-- | The last case, written with a word of another language or as a guard.
lastCases :: Program -> [Problem]
lastCases p = [e | e <- lastEquations p, Just s <- [place e], textAt (source p) s == "else"] ++ concatMap alternative (rows p) ++ concatMap guard (rows p)
  where
    alternative row = case row of
      t : a : _ | isLast t, word a == "->" -> [renamed t (tr "In a case, _ stands for everything else.") "_"]
      _ -> []
    guard row = case row of
      b : t : e : _ | word b == "|", isLast t, word e == "=" -> [renamed t (tr "The last guard is called ‘otherwise’.") "otherwise"]
      _ -> []
    isLast t = word t `elem` ["else", "default"]
    renamed t message' new = repaired p (tokenSpan t) "word" message' [Edit (tokenSpan t) new]

-- | Signs and words of other languages in conditions.
conditions :: Program -> [Problem]
conditions p = concatMap concat [map both conditional, map either' conditional, map oneSided conditional, map chained conditional, map negation conditional, map atLeast conditional, map power behind, map increment behind]
  where
    behind = tails (tokens p)
    conditional = filter (any ((`elem` ["if", "|", "when", "unless"]) . word)) (rows p)
    both row = [inHaskell "&&" t | t <- between row, word t `elem` ["and", "AND", "And", "&"]]
    either' row = [inHaskell "||" t | t <- between row, word t `elem` ["or", "OR", "Or"]]
    -- Tokens between two values.
    between row = [t | x : t : y : _ <- tails row, isOperand (word x), isOperand (word y)]
    negation row = [inHaskell "not " t | x : t : y : _ <- tails row, word t == "!", isGlued t y, not (isGlued x t) || word x == "("]
    atLeast row = [inHaskell ">=" t | t <- takeWhile ((/= "then") . word) row, word t == "=>", "\\" `notElem` map word row]
    -- side == LeftBumper || RightBumper
    oneSided row =
      [ repaired p (tokenSpan b) "operator" (trWith "On both sides of ‘{sign}’ stands a whole comparison." ["sign" =: word t]) [Edit (nothingAt (from b)) (word x <> " " <> word e <> " ")]
        | x : e : a : t : b : more <- tails row,
          isName (word x) && isComparison (word e) && isValue a && word t `elem` ["||", "&&"] && isValue b,
          maybe True (\n -> not (isComparison (word n)) && not (isOperand (word n) && word n /= ")" && word n /= "then")) (listToMaybe more)
      ]
    isValue t = isNumeral (word t) || isConstructor (word t) && word t `notElem` ["True", "False"]
    isComparison w = w `elem` ["==", "/=", "<", ">", "<=", ">="]
    -- 1 < x < 2
    chained row =
      [ repaired p (spanOf a c) "operator" (tr "Two comparisons cannot follow one another.") [Edit (nothingAt (from o)) ("&& " <> word b <> " ")]
        | a : e : b : o : c : _ <- tails row,
          isComparison (word e) && isComparison (word o),
          all isSimple [a, b, c]
      ]
    isSimple t = isOperand (word t) && word t `notElem` ["(", ")", "\"", "_"]
    inHaskell ours t = operator (tokenSpan t) (writtenAs ours t) t ours
    writtenAs ours t = case word t of
      "=>" -> tr "‘Greater or equal’ is written >=, not =>."
      "!" -> tr "‘Not’ is written as a word: ‘not’, in place of ‘!’."
      sign -> trWith "In Haskell, ‘{sign}’ is written {code}." ["sign" =: sign, "code" =: ours]
    power ts = case ts of
      t : n : _ | word t == "^", isNumeral (word n), not (isWhole (word n)) -> [operator (tokenSpan t) (tr "‘^’ is for whole numbers; for others there is **.") t "**"]
      _ -> []
    increment ts = case ts of
      n : t : z : _ | isName (word n), word t == "++", isGlued n t, word z == ")", not (isInLoop t) -> [operator (spanOf n t) (tr "To add one, write + 1.") t " + 1"]
      _ -> []
    -- A loop of another language is explained as such.
    isInLoop t = or [word f == "for" | f : _ <- rows p, line (from f) == line (from t)]

    operator :: Span -> Sentence -> Token -> Text -> Problem
    operator s message' t new = repaired p s "operator" message' [Edit (tokenSpan t) new]

-- | Lambda expressions and alternatives whose signs are those of another language.
lambdas :: Program -> [Problem]
lambdas p = concatMap withoutBackslash (rows p) ++ concatMap otherArrow (rows p) ++ concatMap otherArrowInCase (rows p)
  where
    withoutBackslash row =
      [ repaired p (tokenSpan x) "missing-backslash" (trWith "A backslash is missing in front of ‘{name} ->’." ["name" =: word x]) [Edit (nothingAt (from x)) "\\"]
        | o : x : a : _ <- tails row,
          word o == "(",
          isName (word x) || word x == "_",
          word a == "->"
      ]
    otherArrow row =
      [ arrow t (tr "After a backslash and its names comes the arrow ->, not =>.")
        | (_, _ : more) <- [break ((== "\\") . word) row],
          (names, t : _) <- [break ((== "=>") . word) more],
          all ((`notElem` ["->", "="]) . word) names
      ]
    otherArrowInCase row =
      [ arrow t (tr "In a case, an arrow -> goes between a pattern and its value.")
        | c : _ <- [row],
          column (from c) > 1,
          isConstructor (word c) || word c == "_",
          (before, t : _) <- [break ((== "=>") . word) row],
          all ((`notElem` ["::", "if", "|", "\\"]) . word) before
      ]
    arrow t message' = repaired p (tokenSpan t) "missing-arrow" message' [Edit (tokenSpan t) "->"]
