{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.SyntaxErrors
-- Description : Causes of syntax errors, found in the program text.
--
-- GHC reports only where parsing failed. This module searches the tokens ("Rosy.Worker.Explanation.Tokenizer") for common mistakes, the
-- most specific first.
module Rosy.Worker.Explanation.SyntaxErrors
  ( explainSyntax,
  )
where

import Data.Char (isDigit, isLower, isPunctuation, isSymbol)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.CommonSyntaxErrors
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.ParseFailure
import Rosy.Worker.Explanation.SurroundingTokens
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Explains a syntax error. Takes the program, GHC's code (from GHC 9.6 on), its message and its span.
explainSyntax :: Text -> Maybe Int -> Text -> Maybe Span -> Problem
explainSyntax source code messageText spot = fromMaybe fallback (listToMaybe (concatMap ($ failure) causes ++ fallbackSyntaxErrors failure))
  where
    failure = failureOf source code messageText spot
    fallback = case here failure of
      -- Nothing is before it, or it begins a line as no definition does.
      Just t | null (takeWhile ((< from t) . from) (found failure)) || column (from t) == 1 && Text.all isPunctuationOrSymbol (word t) && word t /= "(" -> problemAt (tokenSpan t) "syntax" (trWith "This line is not a program: it cannot be understood from ‘{word}’ on." ["word" =: word t]) (trWith "A line at the left edge defines something, for example: {code}" ["code" =: "main = simulate (drive 50)"])
      Just t -> problemAt (tokenSpan t) "syntax" (trWith "The program cannot be understood from ‘{word}’ on." ["word" =: word t]) (tr "Something before it is missing, too much, or in the wrong column.")
      Nothing -> Problem Error "syntax" spot Nothing (tr "The program ends too early.") (tr "The last line is not finished.") "" []

isPunctuationOrSymbol :: Char -> Bool
isPunctuationOrSymbol c = isPunctuation c || isSymbol c

-- | The most specific first.
causes :: [ParseFailure -> [Problem]]
causes = [unreadableText, misspelling, mistakeInGuards, mistakeInTasks, mistakeInDeclarations, mistakeInCases, missingPart, misplacedWord]

-- | Characters, texts, comments and brackets that cannot be read, and mistakes that are found without the place of the error.
unreadableText :: ParseFailure -> [Problem]
unreadableText failure@ParseFailure {..} =
  concat
    [ [unclosedText s | "string/character literal" `Text.isInfixOf` messageText, s <- maybe [] pure (lastQuote source at)],
      [problemAt (widen at) "syntax" (tr "This comment is never closed.") (tr "End it with -} or start it with -- instead.") | "unterminated" `Text.isInfixOf` messageText],
      [ problemAt (widen at) "character" (trWith "The character ‘{character}’ has no meaning here." ["character" =: c]) (tr "Remove it, or write it inside a text.")
        | maybe ("lexical error" `Text.isInfixOf` messageText) (`elem` [21231, 31623]) code,
          Just c <- [Text.take 1 <$> textFrom source at],
          not (Text.null c)
      ],
      -- GHC has read nothing behind the place that it reports, but the bracket that the line lacks may be missed only at its end.
      filter (maybe True (isBefore . start) . place) (brackets found),
      commonSyntaxErrors failure
    ]
  where
    isBefore p = p <= at || line p == line at && column at > 1

-- | Capital letters, points and colons.
misspelling :: ParseFailure -> [Problem]
misspelling ParseFailure {..} =
  concat
    [ [ problemAt (tokenSpan t) "capital" (trWith "‘{word}’ is written with a small letter." ["word" =: word t]) (trWith "Write: {code}" ["code" =: Text.toLower (word t)])
        | t : _ <- [current],
          Text.toLower (word t) `elem` reserved,
          word t /= Text.toLower (word t)
      ],
      [ problemAt (Span (from x) (tokenEnd z)) "number" (tr "A number has a point, not a comma.") (trWith "Write: {code}" ["code" =: word x <> "." <> word z])
        | given == Just ",",
          Just x <- [listToMaybe (reverse current)],
          comma : z : _ <- [dropWhile ((< at) . from) found],
          (tokenEnd x, tokenEnd comma) == (from comma, from z),
          all (Text.all isDigit . word) [x, z]
      ],
      [ problemAt (Span (from s) (tokenEnd (last onLine))) "too-many-arguments" (tr "‘simulate’ takes one thing only.") (tr "Put what belongs together into brackets, for example: simulate (Velocity 0.5 0)")
        | given == Just ",",
          s : _ <- [[t | t <- onLine, word t == "simulate"]],
          from s < at
      ],
      [ problemAt (tokenSpan t) "missing-colon" (tr "Two colons go between a name and its type.") (trWith "Write: {name} :: …" ["name" =: word f])
        | (f, t) <- take 1 (zip current (drop 1 current)) ++ [(f, t) | f : _ <- [reverse current], Just t <- [here]],
          word t == ":"
      ]
    ]

-- | Signs of functions and their guards.
mistakeInGuards :: ParseFailure -> [Problem]
mistakeInGuards failure@ParseFailure {..} =
  concat
    [ [ problemAt (tokenSpan t) "comparison" (tr "A single = gives a name to something.") (tr "To compare two values, write ==")
        | given == Just "=",
          fmap word (listToMaybe onLine) == Just "|",
          t : _ : _ <- [[x | x <- onLine, word x == "="]]
      ],
      [ problemAt (tokenSpan t) "guard" (tr "No equals sign belongs before the first guard.") (tr "Remove it: each guard has its own.")
        | given == Just "|",
          endsWith "=" failure,
          take 1 words' /= ["data"],
          t : _ <- [reverse current]
      ],
      [ problemAt (tokenSpan t) "missing-equals" (tr "An equals sign goes between a function and its value.") (tr "Replace -> by =")
        | given == Just "->",
          all (`notElem` words') ["::", "case", "\\", "=", "of", "if"],
          not (afterOf source at),
          Just t <- [here]
      ],
      [ problemAt (tokenSpan t) "word" (tr "The last guard is called ‘otherwise’.") (tr "Write: | otherwise = …")
        | given == Just "else",
          endsWith "|" failure,
          Just t <- [here]
      ]
    ]

-- | Loops, blocks of tasks, and names within them.
mistakeInTasks :: ParseFailure -> [Problem]
mistakeInTasks ParseFailure {..} =
  concat
    [ [ problemAt (tokenSpan t) "word" (trWith "Haskell has no loop called ‘{word}’." ["word" =: word t]) (tr "To repeat tasks, write: replicateM_ 4 (do …), or forever")
        | Just t <- [listToMaybe onLine],
          word t `elem` ["for", "while", "repeat", "loop"]
      ],
      [ problemAt (tokenSpan t) "word" (trWith "Before ‘{word}’ a dollar sign is missing." ["word" =: word t]) (if word t == "do" then trWith "Write it between the two: {code}" ["code" =: applied <> " $ do"] else trWith "Write it between the two: {code} …" ["code" =: applied <> " $ " <> word t])
        | Just t <- [here],
          word t == "do" || "in function application" `Text.isInfixOf` messageText && word t `elem` ["\\", "case", "if", "let"],
          applied <- [applicationBefore source (takeWhile ((< at) . from) onLine)],
          not (Text.null applied)
      ],
      [ problemAt (tokenSpan t) "missing-let" (tr "In a ‘do’ block, ‘let’ gives a name to something.") (trWith "Write: let {name} = …" ["name" =: maybe "x" word (listToMaybe onLine)])
        | given == Just "=",
          inBlock "do" source at,
          Just t <- [listToMaybe onLine]
      ],
      [ problemAt (tokenSpan t) "missing-equals" (tr "After ‘let’ and a name comes an equals sign.") (trWith "To name what a task ends with, leave out the let: {code}" ["code" =: Text.strip (shortened (Text.drop (column (tokenEnd l) - 1) (lineOf source (line at))))])
        | given == Just "<-",
          l : _ <- [filter ((== "let") . word) onLine],
          Just t <- [here]
      ]
    ]

-- | Types with their values, lists, pairs and imports.
mistakeInDeclarations :: ParseFailure -> [Problem]
mistakeInDeclarations ParseFailure {..} =
  concat
    [ [ problemAt (tokenSpan t) "capital" (tr "The values of a type begin with a capital letter.") (trWith "Write: {code}" ["code" =: Text.toTitle (Text.take 1 (word t)) <> Text.drop 1 (word t)])
        | take 1 words' `elem` [["data"], ["newtype"]],
          Just t <- [if given `elem` [Just "|", Nothing] then listToMaybe (reverse current) else here],
          Text.all isLower (Text.take 1 (word t)),
          fmap word (listToMaybe (reverse (takeWhile ((< from t) . from) current))) `elem` [Just "=", Just "|"]
      ],
      [ problemAt (tokenSpan t) "syntax" (tr "The values of a type have | between them.") (tr "Write: data Mode = Go | Stop")
        | take 1 words' == ["data"],
          given == Just ",",
          null (openBrackets words'),
          Just t <- [here]
      ],
      [ problemAt (tokenSpan t) "syntax" (tr "The parts of a list or a pair have commas between them.") (tr "Replace the semicolon by a comma.")
        | given == Just ";",
          not (null (openBrackets words')),
          Just t <- [here]
      ],
      [ problemAt (tokenSpan t) "missing-brackets" (tr "Several things together need brackets around them.") (maybe (tr "Write: (first, second)") (\code -> trWith "Write: {code}" ["code" =: code]) (inBrackets t))
        | given == Just ",",
          null (openBrackets words'),
          Just t <- [here]
      ],
      [ problemAt (tokenSpan t) "syntax" (tr "‘type’ gives a type another name, and no values.") (tr "For a type with values of its own, write data.")
        | take 1 words' == ["type"],
          given == Just "|",
          Just t <- take 1 (map Just current)
      ],
      [ problemAt (tokenSpan t) "capital" (tr "The names of modules begin with capital letters.") (tr "Write for example: import Data.List")
        | "import" : _ <- [map word onLine],
          Just t <- [listToMaybe (drop 1 onLine)],
          Text.all isLower (Text.take 1 (word t)),
          word t `notElem` ["qualified", "safe"]
      ]
    ]
  where
    -- All that stands behind the equals sign of the line.
    inBrackets t = case [e | e <- onLine, word e == "=", from e < from t] of
      [e] | rest <- Text.strip (Text.drop (column (from e)) (lineOf source (line at))), not ("--" `Text.isInfixOf` rest), line (from t) == line at, isWholeLine -> Just ("(" <> rest <> ")")
      _ -> Nothing
    isWholeLine = all (\x -> column (from x) == 1) (take 1 (dropWhile ((<= line at) . line . from) found))

-- | Conditions and cases, and the column of a definition.
mistakeInCases :: ParseFailure -> [Problem]
mistakeInCases failure@ParseFailure {..} =
  concat
    [ [ problemAt (tokenSpan t) "comparison" (tr "A single = gives a name to something.") (tr "To compare two values, write ==")
        | given == Just "=",
          lastOf ["if", "|", "then", "else", "="] words' `elem` [Just "if", Just "|"],
          Just t <- [here]
      ],
      [ problemAt (tokenSpan t) "missing-arrow" (tr "In a case, an arrow -> goes between a pattern and its value.") (tr "Replace the = by ->")
        | given == Just "=",
          inCases source at,
          Just t <- [here]
      ],
      [ problemAt (tokenSpan t) "indentation" (tr "The cases after ‘of’ are too far to the left.") (tr "Indent them by two spaces more than the line with ‘case’.")
        | given == Just "->",
          afterOf source at,
          Just t <- [listToMaybe onLine]
      ],
      [ problemAt (Span (from t) (tokenEnd (last condition))) "missing-equals" (tr "This case has no equals sign.") (tr "Write = between its condition and its value.")
        | given == Just "|",
          condition@(t : _) <- [filter ((== line at - 1) . line . from) current],
          word t == "|",
          all ((`notElem` ["=", "->"]) . word) condition
      ],
      [ problemAt (tokenSpan t) "indentation" (tr "This line is too far to the right.") (tr "A definition begins at the left edge of its block.")
        | given `elem` [Just "=", Just "::", Just "|"],
          Just t <- [listToMaybe onLine],
          column (from t) > 1,
          given /= Just "=" || not (inBlock "do" source at),
          not (endsWith "=" failure)
      ]
    ]

-- | Words that belong together, of which one is missing.
missingPart :: ParseFailure -> [Problem]
missingPart failure@ParseFailure {..} =
  concat
    [ [ problemAt (maybe (widen at) tokenSpan here) "missing-then" (tr "After ‘if’ and its condition comes ‘then’.") (tr "Write: if condition then one value else another.")
        | given == Just "else" || missingAfter "if" "then" failure,
          "if" `elem` words',
          "then" `notElem` dropWhile (/= "if") words'
      ],
      [ problemAt (maybe (widen at) tokenSpan (lastToken "if" current)) "missing-else" (tr "This ‘if’ has no ‘else’.") (tr "Say what to do otherwise: if condition then one value else another.")
        | missingAfter "if" "else" failure
      ],
      [ problemAt (maybe (widen at) tokenSpan (lastToken "let" current)) "missing-in" (tr "After ‘let’ and its names comes ‘in’ and a value.") (trWith "Write: let {name} = … in …" ["name" =: maybe "x" word (listToMaybe (drop 1 (dropWhile ((/= "let") . word) current)))])
        | missingAfter "let" "in" failure,
          "do" `notElem` words'
      ],
      [ problemAt (tokenSpan t) "incomplete" (trWith "Something is missing after ‘{word}’." ["word" =: word t]) (tr "Write the value that belongs there.")
        | Just t <- [listToMaybe (reverse current)],
          word t `elem` ["=", "->", "then", "else", "+", "*", "/", "$", "++", "&&", "||", "==", "<-", "::", "of", "in", ","]
      ]
    ]

-- | Words of Haskell that cannot stand here.
misplacedWord :: ParseFailure -> [Problem]
misplacedWord ParseFailure {..} =
  concat
    [ [ problemAt (tokenSpan t) "word" (trWith "‘{word}’ is a word of Haskell itself and cannot be a name." ["word" =: word t]) (tr "Choose another name.")
        | Just t <- [here],
          word t `elem` ["=", "::"],
          Just p <- [listToMaybe (reverse current)],
          word p `elem` reserved
      ],
      [ problemAt (tokenSpan t) "word" (trWith "‘{word}’ is a word of Haskell itself and cannot be used here." ["word" =: word t]) (tr "If it was meant as a name, choose another one.")
        | Just t <- [here],
          word t `elem` reserved,
          word t `notElem` ["then", "else", "of", "in", "where", "import"]
      ],
      [ problemAt (tokenSpan t) "syntax" (tr "An import comes too late.") (tr "Move all imports to the top of the program.")
        | Just t <- [here],
          word t == "import"
      ],
      [ problemAt (tokenSpan t) "syntax" (trWith "‘{word}’ has nothing that it belongs to." ["word" =: word t]) (trWith "Check the lines before it for the ‘{partner}’." ["partner" =: partner (word t)])
        | Just t <- [here],
          word t `elem` ["then", "else", "of", "in"]
      ]
    ]

-- | Whether the part of the definition before the error ends with this word.
endsWith :: Text -> ParseFailure -> Bool
endsWith w failure = fmap word (listToMaybe (reverse (current failure))) == Just w

-- | Whether the current definition has more of the first word than of the second before the error.
missingAfter :: Text -> Text -> ParseFailure -> Bool
missingAfter opener closer = unbalanced opener closer . words'

-- | The word that one belongs to.
partner :: Text -> Text
partner w = case w of
  "of" -> "case"
  "in" -> "let"
  _ -> "if"

shortened :: Text -> Text
shortened t = if Text.length t > 40 then Text.take 38 t <> " …" else t

reserved :: [Text]
reserved = ["case", "class", "data", "default", "deriving", "do", "else", "if", "import", "in", "infix", "infixl", "infixr", "instance", "let", "module", "newtype", "of", "then", "type", "where"]

widen :: Position -> Span
widen p = Span p p {column = column p + 1}

unclosedText :: Span -> Problem
unclosedText s = problemAt s "missing-quote" (tr "This text is not closed.") (tr "End it with a quotation mark \" on the same line.")

-- | The first unmatched bracket. A line that starts at the left edge begins a new definition and ends all brackets.
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
          | otherwise -> [problemAt (tokenSpan t) "bracket" (trWith "‘{word}’ closes a bracket that was opened with ‘{opening}’." ["word" =: word t, "opening" =: word o]) (trWith "Write ‘{closing}’ here, or close the inner bracket first." ["closing" =: closes (word o)])]
        [] -> [problemAt (tokenSpan t) "bracket" (trWith "The bracket ‘{word}’ closes nothing." ["word" =: word t]) (trWith "Remove it, or add the opening ‘{opening}’ that is missing." ["opening" =: opens (word t)])]
      | otherwise = go open rest
    unclosed o = problemAt (tokenSpan o) "bracket" (trWith "The bracket ‘{opening}’ is never closed." ["opening" =: word o]) (trWith "Add ‘{closing}’ where it ends." ["closing" =: closes (word o)])
    closes w = case w of
      "(" -> ")"
      "[" -> "]"
      _ -> "}"
    opens w = case w of
      ")" -> "("
      "]" -> "["
      _ -> "{"
