{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TextualMistakes.Texts
-- Description : Texts with other quotation marks or none, and texts that are joined with other signs than @++@.
module Rosy.Worker.Explanation.TextualMistakes.Texts
  ( quotes,
    texts,
  )
where

import Data.Char (isAlpha)
import Data.List (tails)
import Data.Maybe (listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText (lineOf)
import Rosy.Worker.Explanation.TextRepair
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

inDoubleQuotes :: Sentence
inDoubleQuotes = tr "A text is written between double quotation marks."

-- | Quotation marks of other languages and word processors around a text, and single ones. Of each line the first text.
quotes :: Program -> [Problem]
quotes p =
  [ repaired p place' "character" inDoubleQuotes es
    | row <- rows p,
      opening : rest <- take 1 (filter startsText (tails row)),
      (place', es) <- take 1 (quotedTexts opening rest)
  ]
  where
    startsText (t : _) = any ((`Text.isPrefixOf` word t) . fst) quotationMarks && word t /= "'"
    startsText [] = False

-- | The texts that can begin with a token: where each stands, and the edits that give it double quotation marks.
quotedTexts :: Token -> [Token] -> [(Span, [Edit])]
quotedTexts opening rest =
  [ (spanOf opening closing, [Edit (Span (from opening) (moved 1 (from opening))) "\"", Edit (Span (moved (-1) (tokenEnd closing)) (tokenEnd closing)) "\""])
    | (open, close) <- quotationMarks,
      open `Text.isPrefixOf` word opening,
      closing : _ <- [filter ((close `Text.isSuffixOf`) . word) ([opening | Text.length (word opening) > 2] ++ rest)],
      "\"" `notElem` map word (takeWhile ((< from closing) . from) rest)
  ]
  where
    moved n at = at {column = column at + n}

-- | Pairs of quotation marks. Curly ones are named by "Rosy.Worker.Explanation.ConfusableCharacters", with all of their kind.
quotationMarks :: [(Text, Text)]
quotationMarks = [("«", "»"), ("»", "«"), ("‹", "›"), ("„", "“"), ("„", "”"), ("‚", "‘"), ("'", "'")]

-- | Texts without quotation marks, and joined with other signs than @++@.
texts :: Program -> [Problem]
texts p = concatMap (joins p) (rows p) ++ concatMap (saidInParts p) (rows p) ++ concatMap (unquoted p) (rows p)

joins :: Program -> [Token] -> [Problem]
joins p row =
  [ repaired p (tokenSpan t) "operator" (tr "To join two texts, write ++.") (Edit (tokenSpan t) "++" : [Edit (nothingAt (from n)) "show " | n <- [x, y], isCount n])
    | x : t : y : _ <- tails row,
      word t `elem` [".", "&", "+"],
      any ((== "\"") . word) [x, y],
      all (isOperand . word) [x, y],
      not (any (isNumeral . word) [x, y])
  ]
  where
    -- What a memory holds, in a function that takes only memories of numbers.
    isCount n = isName (word n) && any (\(m, v) -> word m == "Memory" && word v == word n && line (from v) == line (from n)) (zip (tokens p) (drop 1 (tokens p))) && not (null (remembered n)) && all (`elem` ["Int", "Integer", "Double"]) (remembered n)
    remembered n = [word t | s@(f : c : _) <- rows p, word c == "::", Just (word f) == ownerOf p (line (from n)), (m, t) <- zip s (drop 1 s), word m == "Memory"]

-- | @say "bumps: " ++ show n@, whose first text alone belongs to @say@.
saidInParts :: Program -> [Token] -> [Problem]
saidInParts p row =
  [ repaired p (spanOf s l) "operator" (trWith "Only the first text belongs to this ‘{function}’." ["function" =: word s]) [Edit (nothingAt (from first)) "(", Edit (nothingAt (textEnd l)) ")"]
    | s : first : more <- tails row,
      word s `elem` ["say", "Say"],
      word first == "\"" || isName (word first) && word first /= "show",
      j : _ <- [more],
      word j == "++",
      let inside = takeWhile' (0 :: Int) (first : more),
      l : _ <- [reverse inside],
      word l /= "++"
  ]
  where
    takeWhile' depth ts = case ts of
      t : rest
        | word t `elem` [")", "]"] -> if depth == 0 then [] else t : takeWhile' (depth - 1) rest
        | word t `elem` ["(", "["] -> t : takeWhile' (depth + 1) rest
        | depth == 0 && word t `elem` [",", ";", "then", "else", "where", "|", "}"] -> []
        | otherwise -> t : takeWhile' depth rest
      [] -> []
    -- A text is one token, its first quotation mark.
    textEnd t
      | word t == "\"" = let at = from t in at {column = column at + 2 + Text.length (Text.takeWhile (/= '"') (Text.drop (column at) (lineOf (source p) (line at))))}
      | otherwise = tokenEnd t

-- | Words behind @say@ that the program has nowhere else.
unquoted :: Program -> [Token] -> [Problem]
unquoted p row =
  [ repaired p (spanOf first (last ws)) "missing-quote" inDoubleQuotes [Edit (nothingAt (from first)) "\"", Edit (nothingAt (tokenEnd (last ws))) "\""]
    | s : more <- tails row,
      word s `elem` ["say", "Say"],
      ws@(first : _) <- [takeWhile isProse more],
      maybe True ((== ")") . word) (listToMaybe (drop (length ws) more)),
      all (\w -> count w (tokens p) == count w ws) ws,
      length ws > 1 || isName (word first)
  ]
  where
    isProse t = Text.all isAlpha (word t) || word t `elem` ["!", "?"]
    count w = length . filter ((== word w) . word)
