{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.Tokenizer
-- Description : Tokenizer for words, brackets and operators, with positions.
module Rosy.Worker.Explanation.Tokenizer
  ( Token (..),
    tokenize,
    tokenEnd,
    tokenSpan,
  )
where

import Data.Char (isAlphaNum, isSpace)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Problem

-- | A word, bracket or sign of the program with its place.
data Token = Token {word :: Text, from :: Position}
  deriving (Eq, Show)

-- | The end of a token.
tokenEnd :: Token -> Position
tokenEnd t = (from t) {column = column (from t) + max 1 (Text.length (word t))}

-- | All of the token.
tokenSpan :: Token -> Span
tokenSpan t = Span (from t) (tokenEnd t)

-- | Tokens of a program. Comments are skipped; a string literal is one token, a quotation mark.
tokenize :: Text -> [Token]
tokenize source = go (Position 1 1) (Text.unpack source)
  where
    go _ [] = []
    go p ('\n' : rest) = go (Position (line p + 1) 1) rest
    go p ('-' : '-' : rest)
      | not (continuesOperator rest) = go (move 2 p) (dropLine rest)
    go p ('{' : '-' : rest) = uncurry go (comment (1 :: Int) (move 2 p) rest)
    go p ('"' : rest) = Token "\"" p : uncurry go (string (move 1 p) rest)
    go p ('\'' : c : '\'' : rest) | c /= '\\' = Token "'" p : go (move 3 p) rest
    go p ('\'' : '\\' : rest) = let n = length (takeWhile (\x -> x /= '\'' && x /= '\n') rest) in Token "'" p : go (move (n + 3) p) (drop (n + 1) rest)
    go p s@(c : rest)
      | isSpace c = go (move 1 p) rest
      | isWord c = let w = takeWhile isWord s in Token (Text.pack w) p : go (move (length w) p) (drop (length w) s)
      | isSign c = let w = takeWhile isSign s in Token (Text.pack w) p : go (move (length w) p) (drop (length w) s)
      | otherwise = Token (Text.singleton c) p : go (move 1 p) rest
    move n p = p {column = column p + n}
    dropLine = dropWhile (/= '\n')
    continuesOperator (c : _) = isSign c && c /= '-'
    continuesOperator [] = False
    isWord c = isAlphaNum c || c == '_' || c == '\''
    isSign c = c `elem` ("!#$%&*+./<=>?@\\^|-~:" :: String)
    comment 0 p s = (p, s)
    comment n p s = case s of
      [] -> (p, [])
      '-' : '}' : rest -> comment (n - 1) (move 2 p) rest
      '{' : '-' : rest -> comment (n + 1) (move 2 p) rest
      '\n' : rest -> comment n (Position (line p + 1) 1) rest
      _ : rest -> comment n (move 1 p) rest
    string p s = case s of
      [] -> (p, [])
      '\n' : _ -> (p, s)
      '\\' : '\n' : _ -> (move 1 p, drop 1 s)
      '\\' : _ : rest -> string (move 2 p) rest
      '"' : rest -> (move 1 p, rest)
      _ : rest -> string (move 1 p) rest
