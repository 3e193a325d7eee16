{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.SurroundingTokens
-- Description : Tokens and lines around the place of a syntax error.
--
-- What is looked up around a place: the definition, block, case or application that it stands in, and brackets that are open.
module Rosy.Worker.Explanation.SurroundingTokens
  ( -- * Tokens
    takeDefinition,
    applicationBefore,
    lastOf,
    lastToken,
    unbalanced,
    openBrackets,

    -- * Lines
    textFrom,
    lastQuote,
    inCases,
    inBlock,
    afterOf,
  )
where

import Data.Char (isAlpha, isSpace)
import Data.List (find)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem

-- | The application at the end of these tokens of a line, as written: @replicateM_ 4@ of @x = replicateM_ 4@.
applicationBefore :: Text -> [Token] -> Text
applicationBefore source before = case (application, before) of
  (first : _, _ : _) -> textAt source (Span (from first) (endOf (last before)))
  _ -> ""
  where
    application = reverse (go (0 :: Int) (reverse before))
    go _ [] = []
    go n (t : ts)
      | word t `elem` [")", "]", "}"] = t : go (n + 1) ts
      | word t `elem` ["(", "[", "{"] = if n == 0 then [] else t : go (n - 1) ts
      | n == 0, word t `elem` ["=", "->", "<-", "$", "then", "else", "do", "of", "in", ",", ">>", ">>=", "\\"] = []
      | otherwise = t : go n ts
    -- A text is one token, its quotation mark.
    endOf t
      | word t == "\"" = (from t) {column = column (from t) + 2 + Text.length (Text.takeWhile (/= '"') (Text.drop (column (from t)) (lineOf source (line (from t)))))}
      | otherwise = tokenEnd t

-- | Text for a hint, cut where it would be too long.
-- | The last occurrence of any of these words.
lastOf :: [Text] -> [Text] -> Maybe Text
lastOf wanted = find (`elem` wanted) . reverse

lastToken :: Text -> [Token] -> Maybe Token
lastToken w = find ((== w) . word) . reverse

unbalanced :: Text -> Text -> [Text] -> Bool
unbalanced opener closer ws = length (filter (== opener) ws) > length (filter (== closer) ws)

-- | From a reversed list: back to the token that starts at the left edge.
takeDefinition :: [Token] -> [Token]
takeDefinition ts = case break ((== 1) . column . from) ts of
  (inside, first : _) -> inside ++ [first]
  (inside, []) -> inside

-- | The brackets that are open.
openBrackets :: [Text] -> [Text]
openBrackets = foldl (\open w -> if w `elem` [")", "]", "}"] then drop 1 open else [w | w `elem` ["(", "[", "{"]] ++ open) []

-- | The rest of the line from a place on.
textFrom :: Text -> Position -> Maybe Text
textFrom source p = Text.drop (column p - 1) <$> listToMaybe (drop (line p - 1) (Text.splitOn "\n" source))

-- | The quotation mark before a place on its line, to the end of the line.
lastQuote :: Text -> Position -> Maybe Span
lastQuote source at = do
  l <- listToMaybe (drop (line at - 1) (Text.splitOn "\n" source))
  let opening = Text.length (fst (Text.breakOnEnd "\"" l))
  if opening == 0 then Nothing else Just (Span at {column = opening} at {column = Text.length l + 1})

-- | Whether a place is in one of the cases of an @of@.
inCases :: Text -> Position -> Bool
inCases = inBlock "of"

-- | Whether a place is in a block that began with this word: the nearest line before it that stands further left ends so.
inBlock :: Text -> Text -> Position -> Bool
inBlock opener source at = case dropWhile ((>= indent here) . indent) (filter (not . Text.null . Text.strip) above) of
  l : _ -> lastWord l == Just opener
  [] -> False
  where
    ls = Text.splitOn "\n" source
    above = reverse (take (line at - 1) ls)
    here = fromMaybe "" (listToMaybe (drop (line at - 1) ls))
    indent = Text.length . Text.takeWhile isSpace
    lastWord = fmap (Text.takeWhileEnd isAlpha) . listToMaybe . reverse . Text.words

-- | Whether the line before ends with @of@.
afterOf :: Text -> Position -> Bool
afterOf source at = case reverse (filter (not . Text.null . Text.strip) (take (line at - 1) (Text.splitOn "\n" source))) of
  l : _ -> listToMaybe (reverse (Text.words l)) == Just "of"
  [] -> False
