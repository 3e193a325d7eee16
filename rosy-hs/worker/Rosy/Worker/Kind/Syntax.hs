{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind.Syntax
-- Description : Why a program cannot be read, found in its text.
--
-- GHC says only where it gave up. This module looks at the text with a small scanner ("Rosy.Worker.Kind.Tokens") for the
-- mistakes that beginners make, in the order in which they explain most.
module Rosy.Worker.Kind.Syntax
  ( explainSyntax,
  )
where

import Data.Char (isAlpha, isDigit, isLower, isSpace)
import Data.List (find)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Kind.Habits
import Rosy.Worker.Kind.Tokens
import Rosy.Worker.Kind.Words
import Rosy.Worker.Problem

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
    -- Brackets that are open.
    missing ws = filter (`elem` ["(", "[", "{"]) (foldl (\open w -> if w `elem` [")", "]", "}"] then drop 1 open else [w | w `elem` ["(", "[", "{"]] ++ open) [] ws)
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
        habits source found current at,
        [ problemAt (spanning t) "capital" (quoted (word t) <> " is written with a small letter.") ("Write: " <> Text.toLower (word t) <> ".")
          | t : _ <- [current],
            Text.toLower (word t) `elem` reserved,
            word t /= Text.toLower (word t)
        ],
        [ problemAt (Span (from x) (upTo z)) "number" "A number has a point, not a comma." ("Write " <> word x <> "." <> word z <> ".")
          | given == Just ",",
            Just x <- [listToMaybe (reverse current)],
            comma : z : _ <- [dropWhile ((< at) . from) found],
            (upTo x, upTo comma) == (from comma, from z),
            all (Text.all isDigit . word) [x, z]
        ],
        [ problemAt (Span (from s) (upTo (last onLine))) "too-many-arguments" "‘simulate’ takes one thing only." "Put what belongs together into brackets, for example: simulate (Velocity 0.5 0)."
          | given == Just ",",
            s : _ <- [[t | t <- onLine, word t == "simulate"]],
            from s < at
        ],
        [ problemAt (spanning t) "missing-colon" "Two colons stand between a name and its type." ("Write: " <> word f <> " :: …")
          | (f, t) <- take 1 (zip current (drop 1 current)) ++ [(f, t) | f : _ <- [reverse current], Just t <- [here]],
            word t == ":"
        ],
        [ problemAt (spanning t) "comparison" "A single = gives a name to something." "To compare two values, write ==."
          | given == Just "=",
            fmap word firstOnLine == Just "|",
            t : _ : _ <- [[x | x <- onLine, word x == "="]]
        ],
        [ problemAt (spanning t) "guard" "No equals sign stands before the first guard." "Remove it: each guard has its own."
          | given == Just "|",
            endsWith "=",
            take 1 words' /= ["data"],
            t : _ <- [reverse current]
        ],
        [ problemAt (spanning t) "missing-equals" "Between a function and its value stands an equals sign." "Replace -> by =."
          | given == Just "->",
            all (`notElem` words') ["::", "case", "\\", "=", "of", "if"],
            not (afterOf source at),
            Just t <- [here]
        ],
        [ problemAt (spanning t) "word" "The last guard is called ‘otherwise’." "Write: | otherwise = …"
          | given == Just "else",
            endsWith "|",
            Just t <- [here]
        ],
        [ problemAt (spanning t) "word" ("Haskell has no loop called " <> quoted (word t) <> ".") "To repeat tasks, write: replicateM_ 4 (do …), or forever."
          | Just t <- [firstOnLine],
            word t `elem` ["for", "while", "repeat", "loop"]
        ],
        [ problemAt (spanning t) "word" "Before ‘do’ a dollar sign is missing." "Write it between the two: replicateM_ 4 $ do."
          | given == Just "do",
            Just t <- [here]
        ],
        [ problemAt (spanning t) "missing-let" "In a ‘do’ block, ‘let’ gives a name to something." ("Write: let " <> maybe "x" word firstOnLine <> " = …")
          | given == Just "=",
            inBlock "do" source at,
            Just t <- [firstOnLine]
        ],
        [ problemAt (spanning t) "missing-equals" "After ‘let’ and a name comes an equals sign." "To name what a task ends with, leave out the let: x <- task."
          | given == Just "<-",
            "let" `elem` map word onLine,
            Just t <- [here]
        ],
        [ problemAt (spanning t) "capital" "The values of a type begin with a capital letter." ("Write " <> Text.toTitle (Text.take 1 (word t)) <> Text.drop 1 (word t) <> ".")
          | take 1 words' `elem` [["data"], ["newtype"]],
            Just t <- [if given `elem` [Just "|", Nothing] then listToMaybe (reverse current) else here],
            Text.all isLower (Text.take 1 (word t)),
            fmap word (listToMaybe (reverse (takeWhile ((< from t) . from) current))) `elem` [Just "=", Just "|"]
        ],
        [ problemAt (spanning t) "syntax" "The values of a type have | between them." "Write: data Mode = Go | Stop."
          | take 1 words' == ["data"],
            given == Just ",",
            null (missing words'),
            Just t <- [here]
        ],
        [ problemAt (spanning t) "syntax" "The parts of a list or a pair have commas between them." "Replace the semicolon by a comma."
          | given == Just ";",
            not (null (missing words')),
            Just t <- [here]
        ],
        [ problemAt (spanning t) "missing-brackets" "Several things together need brackets around them." "Write: (first, second)."
          | given == Just ",",
            null (missing words'),
            Just t <- [here]
        ],
        [ problemAt (spanning t) "syntax" "‘type’ gives a type another name, and no values." "For a type with values of its own, write data."
          | take 1 words' == ["type"],
            given == Just "|",
            Just t <- take 1 (map Just current)
        ],
        [ problemAt (spanning t) "capital" "The names of modules begin with capital letters." "Write for example: import Data.List."
          | "import" : _ <- [map word onLine],
            Just t <- [listToMaybe (drop 1 onLine)],
            Text.all isLower (Text.take 1 (word t)),
            word t `notElem` ["qualified", "safe"]
        ],
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
            given /= Just "=" || not (inBlock "do" source at),
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
        ],
        slips found at
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

-- | Whether a place is in one of the cases of an @of@.
inCases :: Text -> Place -> Bool
inCases = inBlock "of"

-- | Whether a place is in a block that began with this word: the nearest line before it that stands further left ends so.
inBlock :: Text -> Text -> Place -> Bool
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
afterOf :: Text -> Place -> Bool
afterOf source at = case reverse (filter (not . Text.null . Text.strip) (take (line at - 1) (Text.splitOn "\n" source))) of
  l : _ -> listToMaybe (reverse (Text.words l)) == Just "of"
  [] -> False
