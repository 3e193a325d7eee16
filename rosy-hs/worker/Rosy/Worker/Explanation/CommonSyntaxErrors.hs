{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.CommonSyntaxErrors
-- Description : Syntax errors from habits of other languages and from wrong columns.
--
-- Recognises, for example, comments with #, @elif@, records with colons, and keywords in the wrong column. These checks come before the
-- general ones of "Rosy.Worker.Explanation.SyntaxErrors".
module Rosy.Worker.Explanation.CommonSyntaxErrors
  ( commonSyntaxErrors,
    fallbackSyntaxErrors,
  )
where

import Data.Char (isLower)
import Data.List (find)
import Data.Maybe (listToMaybe)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.ParseFailure
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | The likely causes, the most likely first.
commonSyntaxErrors :: ParseFailure -> [Problem]
commonSyntaxErrors failure = concatMap ($ failure) [wrongLineStart, missingEquals, otherLanguage, missingPartOfExpression, wrongColumns, missingPartOfDeclaration]

-- | A comment of another language, or a word at the left edge that belongs to the line above.
wrongLineStart :: ParseFailure -> [Problem]
wrongLineStart ParseFailure {..} =
  [ problemAt (tokenSpan t) "comment" (tr "A comment begins with two dashes.") (tr "Write: -- and after it what you want to say.")
    | Just t <- [firstOnLine],
      any (`Text.isPrefixOf` word t) ["#", "//", "/*"]
  ]
    ++ [ problemAt (tokenSpan t) "indentation" (trWith "‘{word}’ is at the left edge, where something new begins." ["word" =: word t]) (tr "Put spaces in front of it: it belongs to the line above.")
         | Just t <- [here],
           column (from t) == 1,
           word t `elem` ["where", "|", "then", "else", "of", "in", "=", "->"],
           not (null current)
       ]
  where
    firstOnLine = listToMaybe onLine

-- | A definition without its equals sign.
missingEquals :: ParseFailure -> [Problem]
missingEquals ParseFailure {..} =
  [ problemAt (Span (from f) (tokenEnd l)) "missing-equals" (if line (from l) < line at then tr "At the end of this line an equals sign is missing." else tr "Here an equals sign is missing.") (trWith "Write: {code} = …" ["code" =: textAt source (Span (from f) (tokenEnd l))])
    | given `elem` map Just ["if", "case", "let", "do", "\\"],
      f : _ <- [current],
      l : _ <- [reverse current],
      line (from f) == line (from l),
      Text.all isLower (Text.take 1 (word f)),
      column (from f) == 1,
      word f `notElem` ["if", "case", "let", "do", "data", "newtype", "type", "class", "instance", "import", "module", "where", "deriving", "infixl", "infixr", "infix"],
      all (`notElem` words') ["=", "|", "::", "->", "<-", "if", "case", "let", "do", "$"]
  ]

-- | Words and signs as other languages or mathematics have them.
otherLanguage :: ParseFailure -> [Problem]
otherLanguage ParseFailure {..} =
  concat
    [ [ problemAt (tokenSpan t) "guard" (tr "A bar is missing in front of ‘otherwise’.") (tr "Write: | otherwise = …")
        | Just t <- [firstOnLine],
          word t == "otherwise",
          "|" `elem` words'
      ],
      [ problemAt (tokenSpan t) "unit" (tr "A number is written without its unit.") (tr "Write: degreesToRadians 90, or degreesToOrientation 90")
        | t : _ <- [filter (("°" `Text.isPrefixOf`) . word) current]
      ],
      [ problemAt (tokenSpan t) "word" (trWith "‘{word}’ is two words in Haskell." ["word" =: word t]) (tr "Write: else if")
        | t : _ <- [filter ((`elem` ["elif", "elsif", "elseif"]) . word) onLine]
      ],
      [ problemAt (tokenSpan t) "field-value" (tr "An equals sign goes between a field and its value.") (trWith "Write: {code} = …" ["code" =: word f])
        | given == Just ":",
          "{" `elem` words',
          take 1 words' `notElem` [["data"], ["newtype"]],
          Just t <- [here],
          f : _ <- [reverse current]
      ]
    ]
  where
    firstOnLine = listToMaybe onLine

-- | A @case@ without @of@, a lambda without its arrow.
missingPartOfExpression :: ParseFailure -> [Problem]
missingPartOfExpression ParseFailure {..} =
  [ problemAt (tokenSpan t) "missing-of" (tr "After ‘case’ and its value comes ‘of’.") (trWith "Write: {code}" ["code" =: Text.strip (Text.drop (column (from t) - 1) (fst (Text.breakOn "->" (lineOf source (line (from t)))))) <> " of"])
    | given == Just "->",
      length (filter (== "case") words') > length (filter (== "of") words'),
      "\\" `notElem` words',
      Just t <- [find ((== "case") . word) (reverse current)]
  ]
    ++ [ problemAt (tokenSpan t) "missing-arrow" (tr "After a backslash and its names comes an arrow.") (trWith "Write: \\{name} -> …" ["name" =: maybe "x" word name])
         | given == Just "=",
           (names, slash : _) <- [break ((== "\\") . word) (reverse onLineBefore)],
           word slash == "\\",
           all ((`notElem` ["->", "="]) . word) names,
           let name = listToMaybe names,
           Just t <- [here]
       ]

-- | Lines of one block that begin in different columns.
wrongColumns :: ParseFailure -> [Problem]
wrongColumns ParseFailure {..} =
  [ problemAt (tokenSpan t) "indentation" (tr "The names after ‘let’ do not begin in the same column.") (tr "Put them exactly below each other.")
    | length (filter (== "let") words') > length (filter (== "in") words'),
      "do" `notElem` words',
      given /= Just "in",
      "in" `elem` map word (takeWhile ((> 1) . column . from) (dropWhile ((< at) . from) found)),
      Just t <- [find ((== "let") . word) (reverse current)]
  ]
    ++ [ problemAt (tokenSpan t) "indentation" (tr "The lines of this ‘do’ do not begin in the same column.") (tr "Put them exactly below each other.")
         | given == Just "do",
           maybe True (`elem` ["=", "->", "then", "else", "(", "$", ">>", "<-"]) (listToMaybe (reverse words')),
           Just t <- [here]
       ]

-- | A class without @where@, an "or" in a pattern, a comma in a type.
missingPartOfDeclaration :: ParseFailure -> [Problem]
missingPartOfDeclaration ParseFailure {..} =
  concat
    [ [ problemAt (Span (Position l 1) (Position l (Text.length text + 1))) "missing-where" (tr "At the end of this line ‘where’ is missing.") (trWith "Write: {code}" ["code" =: Text.stripEnd text <> " where"])
        | (l, text) : _ <- [dropWhile (Text.null . Text.strip . snd) (reverse (take (line at - 1) numbered))],
          take 1 (Text.words text) `elem` [["class"], ["instance"]],
          "where" `notElem` Text.words text,
          column at > 1
      ],
      [ problemAt (tokenSpan t) "pattern" (tr "A pattern has no ‘or’.") (tr "Write one equation for each.")
        | t : _ <- [[x | x <- take 1 (maybe id (:) here (reverse onLineBefore)) ++ take 1 (reverse onLineBefore), word x == "|"]],
          open (map word (takeWhile ((< from t) . from) onLineBefore)) > 0,
          all ((`notElem` ["=", "["]) . word) (takeWhile ((< from t) . from) onLineBefore)
      ],
      [ problemAt (tokenSpan t) "missing-arrow" (tr "In a type, arrows go between the parts.") (tr "Write -> instead of the comma.")
        | given == Just ",",
          "::" `elem` map word onLineBefore,
          all ((`notElem` ["->", "=", "("]) . word) onLineBefore,
          Just t <- [here]
      ]
    ]
  where
    numbered = zip [1 ..] (Text.splitOn "\n" source)
    open ws = length (filter (== "(") ws) - length (filter (== ")") ws)

-- | Causes that are checked last: a definition with two equals signs on the line before.
fallbackSyntaxErrors :: ParseFailure -> [Problem]
fallbackSyntaxErrors ParseFailure {..} =
  [ problemAt (tokenSpan t) "definition" (tr "A definition has a single equals sign.") (tr "Two of them compare: write = here.")
    | let earlier = takeWhile ((< at) . from) found,
      l : _ <- [reverse (map (line . from) earlier)],
      let above = [x | x <- earlier, line (from x) == l],
      all ((`notElem` ["=", "|", "if", "->", "<-", "case"]) . word) above,
      maybe False ((> 1) . column . from) (listToMaybe above),
      t : _ <- [filter ((== "==") . word) above]
  ]
