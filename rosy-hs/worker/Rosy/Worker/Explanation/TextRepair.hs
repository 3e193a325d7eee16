{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TextRepair
-- Description : Tokens of a program by line, and problems whose repair is an edit of the text.
--
-- For mistakes that are found in the text. The hint of such a problem shows the line as it is after the repair. Pure.
module Rosy.Worker.Explanation.TextRepair
  ( -- * Programs
    Program (..),
    programOf,
    chunkOf,
    ownerOf,

    -- * Problems with a repair
    repaired,
    repairedWith,
    lineAfter,
    lastEquations,
    edited,
    nothingAt,
    linesRemoved,
    shortened,

    -- * Tokens
    isGlued,
    isName,
    isConstructor,
    isNumeral,
    isWhole,
    isOperand,
    spanOf,
    capitalised,
    shown,
  )
where

import Data.Char (isAlpha, isDigit, isLower, isUpper)
import Data.List (groupBy, nub, sortOn)
import Data.Maybe (listToMaybe)
import Data.Ord (Down (..))
import Data.Text (Text)
import qualified Data.Text as Text
import Numeric (showFFloat)
import Rosy.Worker.Explanation.MessageText (lineOf, textAt)
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | A program with its tokens, in which a decimal number is one token.
data Program = Program
  { source :: Text,
    tokens :: [Token],
    -- | The tokens of each line that has one.
    rows :: [[Token]]
  }

programOf :: Text -> Program
programOf t = Program t found (groupBy (\x y -> line (from x) == line (from y)) found)
  where
    found = joined (tokenize t)
    joined (a : d : b : rest)
      | isWhole (word a), word d == ".", isGlued a d, isGlued d b, Text.all isDigit (Text.take 1 (word b)) = joined (a {word = word a <> "." <> word b} : rest)
    joined (a : rest) = a : joined rest
    joined [] = []

-- | Number of the definition, or part of one, that a line belongs to: a line that starts at the left edge begins a new one.
chunkOf :: Program -> Int -> Int
chunkOf p l = length (takeWhile (<= l) [line (from t) | t : _ <- rows p, column (from t) == 1])

-- | The first word of the definition that a line belongs to.
ownerOf :: Program -> Int -> Maybe Text
ownerOf p l = listToMaybe (reverse [word t | t : _ <- rows p, column (from t) == 1, line (from t) <= l])

-- | A problem with the edits that repair it.
repaired :: Program -> Span -> Text -> Sentence -> [Edit] -> Problem
repaired p s k m es = repairedWith p s k m (lineAfter es (source p) (start s)) es

-- | The same with a hint of its own; without edits it has no repair.
repairedWith :: Program -> Span -> Text -> Sentence -> Sentence -> [Edit] -> Problem
repairedWith p s k m h es = (problemAt s k m h) {fixes = [Fix (titleOf p s es) es | not (null es)]}

-- | A hint that shows the line of a place as it is after the edits.
lineAfter :: [Edit] -> Text -> Position -> Sentence
lineAfter es t at = trWith "Write: {code}" ["code" =: shortened 90 (Text.strip (lineOf (edited es t) (line at)))]

-- | A text of so many characters at most.
shortened :: Int -> Text -> Text
shortened most t = if Text.length t > most then Text.take (most - 2) t <> " …" else t

-- | What a repair of the problem at a place writes or removes, for its button.
titleOf :: Program -> Span -> [Edit] -> Sentence
titleOf p s es = case (es, filter (not . Text.null) (map by es)) of
  (_, []) | all isOfLines es -> if sum (map height es) == 1 then tr "Remove this line" else tr "Remove these lines"
  ([e], []) -> trWith "Remove {code}" ["code" =: excerpt (textAt (source p) (replaces e))]
  (_, []) | length changed == length es -> trWith "Remove this from {count lines} lines" ["lines" =# length changed]
  ([_], [new]) | not (Text.null (Text.strip new)) -> writes new
  (_, news)
    | [l] <- changed, not (any ("\n" `Text.isInfixOf`) news) -> writes (rewritten l)
    | [new] <- nub news, length news == length es -> trWith "Write {code} in {count places} places" ["code" =: excerpt new, "places" =# length es]
    | [new] <- news -> writes new
    | otherwise -> trWith "Change {count lines} lines" ["lines" =# length changed]
  where
    writes new = trWith "Write {code}" ["code" =: excerpt new]
    -- The first line of it.
    excerpt = shortened 40 . Text.takeWhile (/= '\n') . Text.strip
    changed = nub (concatMap (linesOf . replaces) es)
    linesOf (Span a b) = [line a .. line b]
    isOfLines (Edit (Span a b) _) = column a == 1 && column b == 1 && line b > line a
    height (Edit (Span a b) _) = line b - line a
    -- A line after the edits, from the first token that they or the problem touch to the last.
    rewritten l = Text.unwords . Text.words $ Text.dropEnd (Text.length before + 1 - to) (Text.drop (begin - 1) (lineOf (edited es (source p)) l))
      where
        before = lineOf (source p) l
        begin = widened minimum from (map start places)
        to = widened maximum tokenEnd (map end places)
        places = [s | linesOf s == [l]] ++ map replaces es
        widened outermost side found = let at = outermost found in column (maybe at side (listToMaybe [t | t <- tokens p, from t < at, at < tokenEnd t]))

-- | @otherwise@ or @else@ at the left edge, where the last equation of a function is meant.
lastEquations :: Program -> [Problem]
lastEquations p =
  [ repaired p (tokenSpan t) "word" (trWith "An equation of ‘{function}’ begins with this name, not with ‘{word}’." ["word" =: word t, "function" =: word f]) [Edit (tokenSpan t) (Text.unwords (word f : replicate n "_"))]
    | (before, t : e : _) <- zip (drop 1 (scanl (flip (:)) [] (rows p))) (drop 1 (rows p)),
      column (from t) == 1,
      word t `elem` ["otherwise", "else"],
      word e == "=",
      (f : left) : _ <- [[row | row@(x : _) <- before, column (from x) == 1]],
      isName (word f),
      let n = atoms (0 :: Int) (takeWhile ((`notElem` ["=", "|"]) . word) left),
      n > 0
  ]
  where
    atoms :: Int -> [Token] -> Int
    atoms _ [] = 0
    atoms depth (t : ts)
      | word t `elem` ["(", "["] = (if depth == 0 then 1 else 0) + atoms (depth + 1) ts
      | word t `elem` [")", "]"] = atoms (depth - 1) ts
      | otherwise = (if depth == 0 then 1 else 0) + atoms depth ts

-- | A text after edits, which do not overlap.
edited :: [Edit] -> Text -> Text
edited es t = foldl one t (sortOn (Down . start . replaces) es)
  where
    one now (Edit (Span a b) new) = textAt now (Span (Position 1 1) a) <> new <> textAt now (Span b (endOf now))
    endOf now = let ls = Text.splitOn "\n" now in Position (length ls) (maybe 1 ((+ 1) . Text.length) (listToMaybe (reverse ls)))

nothingAt :: Position -> Span
nothingAt at = Span at at

-- | Removes lines, from one number to another.
linesRemoved :: Int -> Int -> Edit
linesRemoved a b = Edit (Span (Position a 1) (Position (b + 1) 1)) ""

-- | Whether no space stands between two tokens.
isGlued :: Token -> Token -> Bool
isGlued a b = tokenEnd a == from b

-- | A name that begins with a small letter.
isName :: Text -> Bool
isName = maybe False (isLower . fst) . Text.uncons

isConstructor :: Text -> Bool
isConstructor = maybe False (isUpper . fst) . Text.uncons

isWhole :: Text -> Bool
isWhole w = not (Text.null w) && Text.all isDigit w

-- | A number, with a decimal point or without.
isNumeral :: Text -> Bool
isNumeral w = case Text.splitOn "." w of
  [a] -> isWhole a
  [a, b] -> isWhole a && isWhole b
  _ -> False

-- | Whether a value may end or begin with this token.
isOperand :: Text -> Bool
isOperand w = w `elem` ["(", ")", "\"", "_"] || isNumeral w || maybe False (isAlpha . fst) (Text.uncons w) && w `notElem` ["if", "then", "else", "of", "case", "let", "in", "where", "do"]

spanOf :: Token -> Token -> Span
spanOf a b = Span (from a) (tokenEnd b)

capitalised :: Text -> Text
capitalised w = Text.toUpper (Text.take 1 w) <> Text.drop 1 w

-- | A number with at most four decimals.
shown :: Double -> Text
shown x = Text.dropWhileEnd (== '.') (Text.dropWhileEnd (== '0') (Text.pack (showFFloat (Just 4) x "")))
