{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind.Syntax
-- Description : Why a program cannot be read, found in its text.
--
-- GHC says only where it gave up. This module looks at the text with a small scanner (words, brackets, texts, comments) for the
-- mistakes that beginners make, in the order in which they explain most.
module Rosy.Worker.Kind.Syntax
  ( explainSyntax,

    -- * The words of a program
    Token (..),
    scan,
    upTo,
  )
where

import Data.Char (isAlphaNum, isSpace)
import Data.List (find)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Kind.Words
import Rosy.Worker.Problem

-- | A word, bracket or sign of the program with its place.
data Token = Token {word :: Text, from :: Place}
  deriving (Eq, Show)

-- | The end of a token.
upTo :: Token -> Place
upTo t = (from t) {column = column (from t) + max 1 (Text.length (word t))}

spanning :: Token -> Span
spanning t = Span (from t) (upTo t)

-- | What keeps a text from being read. Takes the program, GHC's sentence and its place.
explainSyntax :: Text -> Text -> Maybe Span -> Problem
explainSyntax source said spot = fromMaybe fallback (listToMaybe (concat findings))
  where
    found = scan source
    at = maybe (Place 1 1) start spot
    before = takeWhile ((< at) . from) found
    here = listToMaybe (dropWhile ((< at) . from) found)
    given = word <$> here
    -- The tokens of the definition in which reading stopped, up to there.
    current = reverse (takeDefinition (reverse before))
    words' = map word current
    onLine = [t | t <- found, line (from t) == line at]
    firstOnLine = listToMaybe onLine
    endsWith w = fmap word (listToMaybe (reverse current)) == Just w
    missingAfter opener closer = unbalanced opener closer words'

    findings =
      [ [unclosedText s | "string/character literal" `Text.isInfixOf` said, s <- maybe [] pure (lastQuote source at)],
        [problemAt (widen at) "syntax" "This comment is never closed." "End it with -} or start it with -- instead." | "unterminated" `Text.isInfixOf` said],
        [ problemAt (widen at) "character" ("The character " <> quoted c <> " has no meaning here.") (curly c)
          | "lexical error" `Text.isInfixOf` said,
            Just c <- [Text.take 1 <$> textFrom source at],
            not (Text.null c)
        ],
        brackets found,
        [ problemAt (spanning t) "comparison" "A single = gives a name to something." "To compare two values, write ==."
          | given == Just "=",
            lastOf ["if", "|", "then", "else", "="] words' `elem` [Just "if", Just "|"],
            Just t <- [here]
        ],
        [ problemAt (spanning t) "missing-arrow" "In a case, an arrow -> stands between a pattern and its value." "Replace the = by ->."
          | given == Just "=",
            inCases source at,
            Just t <- [here]
        ],
        [ problemAt (spanning t) "indentation" "The cases after ‘of’ stand too far to the left." "Indent them by two spaces more than the line with ‘case’."
          | given == Just "->",
            afterOf source at,
            Just t <- [firstOnLine]
        ],
        [ problemAt (spanning t) "indentation" "This line stands too far to the right." "A definition begins at the left edge of its block."
          | given `elem` [Just "=", Just "::", Just "|"],
            Just t <- [firstOnLine],
            column (from t) > 1,
            not (endsWith "=")
        ],
        [ problemAt (maybe (widen at) spanning here) "missing-then" "After ‘if’ and its condition comes ‘then’." "Write: if condition then one value else another."
          | given == Just "else" || missingAfter "if" "then",
            "if" `elem` words',
            "then" `notElem` dropWhile (/= "if") words'
        ],
        [ problemAt (maybe (widen at) spanning (lastToken "if" current)) "missing-else" "This ‘if’ has no ‘else’." "Say what to do otherwise: if condition then one value else another."
          | missingAfter "if" "else"
        ],
        [ problemAt (maybe (widen at) spanning (lastToken "let" current)) "missing-in" "After ‘let’ and its names comes ‘in’ and a value." "Write: let v = 0.5 in Velocity v 0."
          | missingAfter "let" "in",
            "do" `notElem` words'
        ],
        [ problemAt (spanning t) "incomplete" ("Something is missing after " <> quoted (word t) <> ".") "Write the value that belongs there."
          | Just t <- [listToMaybe (reverse current)],
            word t `elem` ["=", "->", "then", "else", "+", "*", "/", "$", "++", "&&", "||", "==", "<-", "::", "of", "in", ","]
        ],
        [ problemAt (spanning t) "word" (quoted (word t) <> " is a word of Haskell itself and cannot be a name.") "Choose another name."
          | Just t <- [here],
            word t `elem` ["=", "::"],
            Just p <- [listToMaybe (reverse current)],
            word p `elem` reserved
        ],
        [ problemAt (spanning t) "word" (quoted (word t) <> " is a word of Haskell itself and cannot stand here.") "If it was meant as a name, choose another one."
          | Just t <- [here],
            word t `elem` reserved,
            word t `notElem` ["then", "else", "of", "in", "where", "import"]
        ],
        [ problemAt (spanning t) "syntax" "An import stands too late." "Move all imports to the top of the program."
          | Just t <- [here],
            word t == "import"
        ],
        [ problemAt (spanning t) "syntax" (quoted (word t) <> " has nothing that it belongs to.") ("Check the lines before it for the " <> partner (word t) <> ".")
          | Just t <- [here],
            word t `elem` ["then", "else", "of", "in"]
        ]
      ]
    fallback = case here of
      Just t -> problemAt (spanning t) "syntax" ("The program cannot be understood from " <> quoted (word t) <> " on.") "Something before it is missing, too much, or in the wrong column."
      Nothing -> Problem Error "syntax" spot Nothing "The program ends too early." "The last line is not finished." "" []
    partner w = case w of
      "of" -> "‘case’"
      "in" -> "‘let’"
      _ -> "‘if’"

reserved :: [Text]
reserved = ["case", "class", "data", "default", "deriving", "do", "else", "if", "import", "in", "infix", "infixl", "infixr", "instance", "let", "module", "newtype", "of", "then", "type", "where"]

curly :: Text -> Text
curly c
  | c `elem` ["“", "”", "„"] = "Texts are written between straight quotation marks: \"hello\"."
  | c `elem` ["−", "–", "—"] = "A minus sign is the plain one: -."
  | otherwise = "Remove it, or write it inside a text."

widen :: Place -> Span
widen p = Span p p {column = column p + 1}

-- | The rest of the line from a place on.
textFrom :: Text -> Place -> Maybe Text
textFrom source p = Text.drop (column p - 1) <$> listToMaybe (drop (line p - 1) (Text.splitOn "\n" source))

-- | The quotation mark before a place on its line, to the end of the line.
lastQuote :: Text -> Place -> Maybe Span
lastQuote source at = do
  l <- listToMaybe (drop (line at - 1) (Text.splitOn "\n" source))
  let opening = Text.length (fst (Text.breakOnEnd "\"" l))
  if opening == 0 then Nothing else Just (Span at {column = opening} at {column = Text.length l + 1})

unclosedText :: Span -> Problem
unclosedText s = problemAt s "missing-quote" "This text is not closed." "End it with a quotation mark \" on the same line."

-- | The first bracket without a partner. A line that starts at the left edge begins something new, so brackets end before it.
brackets :: [Token] -> [Problem]
brackets = go []
  where
    go open [] = map unclosed (take 1 (reverse open))
    go open (t : rest)
      | column (from t) == 1, o : _ <- reverse open, line (from t) > line (from o) = [unclosed o]
      | word t `elem` ["(", "[", "{"] = go (t : open) rest
      | word t `elem` [")", "]", "}"] = case open of
        o : others
          | closes (word o) == word t -> go others rest
          | otherwise -> [problemAt (spanning t) "bracket" (quoted (word t) <> " closes a bracket that was opened with " <> quoted (word o) <> ".") ("Write " <> quoted (closes (word o)) <> " here, or close the inner bracket first.")]
        [] -> [problemAt (spanning t) "bracket" ("The bracket " <> quoted (word t) <> " closes nothing.") ("Remove it, or add the opening " <> quoted (opens (word t)) <> " that is missing.")]
      | otherwise = go open rest
    unclosed o = problemAt (spanning o) "bracket" ("The bracket " <> quoted (word o) <> " is never closed.") ("Add " <> quoted (closes (word o)) <> " where it ends.")
    closes w = case w of
      "(" -> ")"
      "[" -> "]"
      _ -> "}"
    opens w = case w of
      ")" -> "("
      "]" -> "["
      _ -> "{"

-- | The last of some words, whichever it is.
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

-- | Whether a place is in one of the cases of an @of@: the nearest line before it that stands further left ends so.
inCases :: Text -> Place -> Bool
inCases source at = case dropWhile ((>= indent here) . indent) (filter (not . Text.null . Text.strip) above) of
  l : _ -> lastWord l == Just "of"
  [] -> False
  where
    ls = Text.splitOn "\n" source
    above = reverse (take (line at - 1) ls)
    here = fromMaybe "" (listToMaybe (drop (line at - 1) ls))
    indent = Text.length . Text.takeWhile isSpace
    lastWord = listToMaybe . reverse . Text.words

-- | Whether the line before ends with @of@.
afterOf :: Text -> Place -> Bool
afterOf source at = case reverse (filter (not . Text.null . Text.strip) (take (line at - 1) (Text.splitOn "\n" source))) of
  l : _ -> listToMaybe (reverse (Text.words l)) == Just "of"
  [] -> False

-- | Cuts a program into tokens. Texts, characters and comments are skipped (a text is one token, a quotation mark).
scan :: Text -> [Token]
scan source = go (Place 1 1) (Text.unpack source)
  where
    go _ [] = []
    go p ('\n' : rest) = go (Place (line p + 1) 1) rest
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
      '\n' : rest -> comment n (Place (line p + 1) 1) rest
      _ : rest -> comment n (move 1 p) rest
    string p s = case s of
      [] -> (p, [])
      '\n' : _ -> (p, s)
      '\\' : '\n' : _ -> (move 1 p, drop 1 s)
      '\\' : _ : rest -> string (move 2 p) rest
      '"' : rest -> (move 1 p, rest)
      _ : rest -> string (move 1 p) rest
