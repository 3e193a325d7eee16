{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind.Habits
-- Description : Why a program cannot be read, when a habit or a column is the reason.
--
-- What hands bring along from other languages (comments with #, @elif@, records with colons), and words that stand in the wrong column. These mistakes are
-- plain to see once looked for, so they are looked for before the others of "Rosy.Worker.Kind.Syntax".
module Rosy.Worker.Kind.Habits
  ( habits,
    slips,
  )
where

import Data.List (find)
import Data.Maybe (listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Kind.Tokens
import Rosy.Worker.Kind.Words
import Rosy.Worker.Problem

-- | The likely reasons, the likeliest first. Takes the program, all its tokens, those of the definition in which reading stopped, up to there, and where that is.
habits :: Text -> [Token] -> [Token] -> Place -> [Problem]
habits source found current at =
  concat
    [ [ problemAt (spanning t) "comment" "A comment begins with two dashes." "Write: -- and behind it what you want to say."
        | Just t <- [firstOnLine],
          any (`Text.isPrefixOf` word t) ["#", "//", "/*"]
      ],
      [ problemAt (spanning t) "indentation" (quoted (word t) <> " stands at the left edge, where something new begins.") "Put spaces in front of it: it belongs to the line above."
        | Just t <- [here],
          column (from t) == 1,
          word t `elem` ["where", "|", "then", "else", "of", "in", "=", "->"],
          not (null current)
      ],
      [ problemAt (spanning t) "guard" "In front of ‘otherwise’ a bar is missing." "Write: | otherwise = …"
        | Just t <- [firstOnLine],
          word t == "otherwise",
          "|" `elem` words'
      ],
      [ problemAt (spanning t) "unit" "A number stands without its unit." "Write: degreesToRadians 90, or degreesToOrientation 90."
        | t : _ <- [filter (("°" `Text.isPrefixOf`) . word) current]
      ],
      [ problemAt (spanning t) "word" (quoted (word t) <> " is two words in Haskell.") "Write: else if."
        | t : _ <- [filter ((`elem` ["elif", "elsif", "elseif"]) . word) onLine]
      ],
      [ problemAt (spanning t) "field-value" "Between a field and its value stands an equals sign." ("Write: " <> word f <> " = …")
        | given == Just ":",
          "{" `elem` words',
          take 1 words' `notElem` [["data"], ["newtype"]],
          Just t <- [here],
          f : _ <- [reverse current]
      ],
      [ problemAt (spanning t) "missing-of" "After ‘case’ and its value comes ‘of’." "Write: case b of"
        | given == Just "->",
          length (filter (== "case") words') > length (filter (== "of") words'),
          "\\" `notElem` words',
          Just t <- [find ((== "case") . word) (reverse current)]
      ],
      [ problemAt (spanning t) "missing-arrow" "Behind a backslash and its names comes an arrow." ("Write: \\" <> maybe "x" word name <> " -> …")
        | given == Just "=",
          (names, slash : _) <- [break ((== "\\") . word) (reverse onLineBefore)],
          word slash == "\\",
          all ((`notElem` ["->", "="]) . word) names,
          let name = listToMaybe names,
          Just t <- [here]
      ],
      [ problemAt (spanning t) "indentation" "The names after ‘let’ do not begin in the same column." "Put them exactly below each other."
        | length (filter (== "let") words') > length (filter (== "in") words'),
          "do" `notElem` words',
          given /= Just "in",
          "in" `elem` map word (takeWhile ((> 1) . column . from) (dropWhile ((< at) . from) found)),
          Just t <- [find ((== "let") . word) (reverse current)]
      ],
      [ problemAt (spanning t) "indentation" "The lines of this ‘do’ do not begin in the same column." "Put them exactly below each other."
        | given == Just "do",
          maybe True (`elem` ["=", "->", "then", "else", "(", "$", ">>", "<-"]) (listToMaybe (reverse words')),
          Just t <- [here]
      ],
      [ problemAt (Span (Place l 1) (Place l (Text.length text + 1))) "missing-where" "At the end of this line ‘where’ is missing." ("Write: " <> Text.stripEnd text <> " where")
        | (l, text) : _ <- [dropWhile (Text.null . Text.strip . snd) (reverse (take (line at - 1) numbered))],
          take 1 (Text.words text) `elem` [["class"], ["instance"]],
          "where" `notElem` Text.words text,
          column at > 1
      ],
      [ problemAt (spanning t) "pattern" "A pattern has no ‘or’." "Write one equation for each."
        | t : _ <- [[x | x <- take 1 (maybe id (:) here (reverse onLineBefore)) ++ take 1 (reverse onLineBefore), word x == "|"]],
          open (map word (takeWhile ((< from t) . from) onLineBefore)) > 0,
          all ((`notElem` ["=", "["]) . word) (takeWhile ((< from t) . from) onLineBefore)
      ],
      [ problemAt (spanning t) "missing-arrow" "In a type, arrows stand between the parts." "Write -> instead of the comma."
        | given == Just ",",
          "::" `elem` map word onLineBefore,
          all ((`notElem` ["->", "=", "("]) . word) onLineBefore,
          Just t <- [here]
      ]
    ]
  where
    here = listToMaybe (dropWhile ((< at) . from) found)
    given = word <$> here
    words' = map word current
    onLine = [t | t <- found, line (from t) == line at]
    onLineBefore = takeWhile ((< at) . from) onLine
    firstOnLine = listToMaybe onLine
    numbered = zip [1 ..] (Text.splitOn "\n" source)
    open ws = length (filter (== "(") ws) - length (filter (== ")") ws)

-- | Reasons that are looked for when nothing else explains it: a definition with two equals signs, on the last line before.
slips :: [Token] -> Place -> [Problem]
slips found at =
  [ problemAt (spanning t) "definition" "A definition has a single equals sign." "Two of them compare: write = here."
    | let before = takeWhile ((< at) . from) found,
      l : _ <- [reverse (map (line . from) before)],
      let onLine = [x | x <- before, line (from x) == l],
      all ((`notElem` ["=", "|", "if", "->", "<-", "case"]) . word) onLine,
      maybe False ((> 1) . column . from) (listToMaybe onLine),
      t : _ <- [filter ((== "==") . word) onLine]
  ]
