{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TextualMistakes.CopiedText
-- Description : Text around a program that was copied along with it, and comments and lists of steps as other languages write them.
module Rosy.Worker.Explanation.TextualMistakes.CopiedText
  ( copiedLines,
    comments,
    numberedSteps,
  )
where

import Data.Char (isAlpha, isDigit)
import Data.List (find)
import Data.Maybe (listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText (lineOf, textAt)
import Rosy.Worker.Explanation.TextRepair
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | A line with its number, counted from 1.
type NumberedLine = (Int, Text)

-- | Lines that were copied along with the program: conflict markers, prompts, code fences, line numbers, imports of other languages,
-- and characters as a web page writes them.
copiedLines :: Program -> [Problem]
copiedLines p = concatMap ($ numberedLines p) [conflictMarkers p, prompts p, codeFences p, lineNumbers p, foreignImports p, characterReferences p]

numberedLines :: Program -> [NumberedLine]
numberedLines p = zip [1 ..] (Text.splitOn "\n" (source p))

filledLines :: [NumberedLine] -> [NumberedLine]
filledLines = filter (not . Text.null . Text.strip . snd)

wholeLine :: Program -> Int -> Span
wholeLine p n = Span (Position n 1) (Position n (Text.length (lineOf (source p) n) + 1))

-- | So many characters at the beginning of a line.
lineStart :: Int -> Int -> Span
lineStart n size = Span (Position n 1) (Position n (1 + size))

-- | The markers that version control leaves around two versions that it could not merge.
conflictMarkers :: Program -> [NumberedLine] -> [Problem]
conflictMarkers p ls = case upTo "<<<<<<<" ls of
  (_, (a, _) : more)
    | (_, (b, _) : rest) <- upTo "=======" more,
      (_, (c, _) : others) <- upTo ">>>>>>>" rest ->
      conflict a b c : conflictMarkers p others
  _ -> []
  where
    upTo mark = break ((mark `Text.isPrefixOf`) . snd)
    conflict a b c =
      (problemAt (wholeLine p a) "syntax" message' hint')
        { fixes =
            [ Fix (tr "Keep the first version") [linesRemoved a a, linesRemoved b c],
              Fix (tr "Keep the second version") [linesRemoved a b, linesRemoved c c]
            ]
        }
    message' = tr "Two versions of the program were merged here, and both are still there."
    hint' = tr "Keep one, and remove the lines with <<<<<<<, ======= and >>>>>>>."

-- | Prompts of an interpreter. A single @>@ counts only if it stands in front of all lines.
prompts :: Program -> [NumberedLine] -> [Problem]
prompts p ls =
  [ repairedWith p (lineStart n (Text.length mark)) "syntax" (message' mark) (if length (removals mark) == 1 then tr "Remove it." else tr "Remove it from every line.") (removals mark)
    | (n, first) : _ <- [filled],
      Just mark <- [find (`Text.isPrefixOf` first) ["ghci>", "Prelude>", "*Main>", ">>>", "λ>", ">"]],
      mark /= ">" || all ((">" `Text.isPrefixOf`) . snd) filled
  ]
  where
    filled = filledLines ls
    message' mark = trWith "‘{word}’ at the left edge was copied along: it is not part of the program." ["word" =: mark]
    removals mark = [Edit (lineStart n size) "" | (n, l) <- filled, Just size <- [promptSize mark l]]
    promptSize mark l = (\rest -> Text.length mark + spaceSize rest) <$> Text.stripPrefix mark l

-- | 1 for a text that begins with a space.
spaceSize :: Text -> Int
spaceSize rest = if " " `Text.isPrefixOf` rest then 1 else 0

codeFences :: Program -> [NumberedLine] -> [Problem]
codeFences p ls =
  [ repairedWith p (wholeLine p n) "syntax" message' (tr "Remove it.") [linesRemoved m m | m <- fenced]
    | fenced <- [fences, reverse buttons],
      n : _ <- [fenced]
  ]
  where
    fences = [n | (n, l) <- ls, "```" `Text.isPrefixOf` l]
    -- What stands above code in a chat: its language, and the button that copies it.
    buttons = [n | (n, l) <- take 2 (filledLines ls), Text.toLower (Text.strip l) `elem` ["haskell", "copy", "copy code", "kopieren", "code kopieren", "copier", "copier le code", "copiar", "copiar código"]]
    message' = tr "This line marks code in a text or a chat: it is not part of the program."

-- | Numbers in front of all lines, each larger than the one before.
lineNumbers :: Program -> [NumberedLine] -> [Problem]
lineNumbers p ls = case filledLines ls of
  filled@((n, first) : _ : _) | all (startsWithDigit . snd) filled, isAscending (mapMaybe (readWhole . digitsOf . snd) filled) -> [copied filled n first]
  _ -> []
  where
    copied filled n first = repairedWith p (lineStart n (Text.length (digitsOf first))) "syntax" message' (tr "Remove them.") (removals filled)
    message' = tr "The numbers of the lines were copied along: they are not part of the program."
    removals filled = [Edit (lineStart n (numberSize l)) "" | (n, l) <- filled]
    startsWithDigit = not . Text.null . digitsOf
    digitsOf = Text.takeWhile isDigit
    isAscending ns = and (zipWith (<) ns (drop 1 ns))
    -- With the sign behind the number and one space.
    numberSize l = Text.length l - Text.length (behindNumber l) + spaceSize (behindNumber l)
    behindNumber = Text.dropWhile (`elem` (".:|" :: String)) . Text.dropWhile isDigit

readWhole :: Text -> Maybe Int
readWhole t = case reads (Text.unpack t) of
  [(n, "")] -> Just n
  _ -> Nothing

-- | Imports of other languages.
foreignImports :: Program -> [NumberedLine] -> [Problem]
foreignImports p ls =
  [ repairedWith p (wholeLine p n) "import" (message' l) (tr "Remove this line.") [linesRemoved n n]
    | (n, l) <- ls,
      isForeign (Text.toLower l) || isOtherModule (Text.words l) || isMisspelt (Text.strip l)
  ]
  where
    message' l = case Text.words l of
      "import" : _ : _ | not (isMisspelt (Text.strip l)) -> trWith "‘{word}’ belongs to other languages: Rosy is always there." ["word" =: shortened 40 (Text.strip l)]
      "import" : _ -> tr "‘Rosy’ is written with a capital letter. But it is always there, without an import."
      w : _ -> trWith "‘{word}’ belongs to other languages: Rosy is always there." ["word" =: w]
      [] -> tr "‘Rosy’ is written with a capital letter. But it is always there, without an import."
    isForeign l = any (`Text.isPrefixOf` l) ["from rosy import", "import rosy ", "#include", "using ", "#!/"] || "import " `Text.isPrefixOf` l && any (`Text.isInfixOf` l) [" from \"", " from '"]
    isOtherModule ws = case ws of
      "import" : w : _ -> Text.takeWhile (`notElem` (".;," :: String)) w `elem` otherModules
      "from" : _ : "import" : _ -> True
      _ -> False
    -- Modules of Python and Java that a first program imports.
    otherModules = Text.words "time math random turtle os sys java numpy robot rospy rclpy microbit pybricks threading"
    isMisspelt l = Text.toLower l == "import rosy" && l /= "import Rosy"

-- | Comments that begin with other signs than two dashes and a space.
comments :: Program -> [Problem]
comments p = concatMap inRow (rows p) ++ docstrings p
  where
    inRow row = [commented p row t | (before, t : behind) <- map (`splitAt` row) [0 .. length row - 1], isCommentSign p before t behind]

-- | A problem with the sign of a comment in a row.
commented :: Program -> [Token] -> Token -> Problem
commented p row t
  | isDashed, not (isDashes (word t)) = repaired p (tokenSpan t) "comment" withoutSpace [Edit (nothingAt (secondColumnBehind (from t))) " "]
  | otherwise = repaired p sign "comment" (otherSign (textAt (source p) sign)) (Edit sign "--" : closing)
  where
    isDashed = "--" `Text.isPrefixOf` word t
    withoutSpace = trWith "‘{sign}’ is read as one sign: a comment needs a space after its two dashes." ["sign" =: word t]
    secondColumnBehind at = at {column = column at + 2}
    sign = Span (from t) (signEnd row t)
    closing = [Edit (tokenSpan e) "" | word t == "<!--", e : _ <- [reverse row], word e == "-->"]

-- | Takes the sign that stands in place of two dashes.
otherSign :: Text -> Sentence
otherSign sign
  | isDashes sign, Text.length sign == 1 = trWith "‘{sign}’ is one long dash: a comment begins with two short ones." ["sign" =: sign]
  | isDashes sign = trWith "‘{sign}’ are long dashes: a comment begins with two short ones." ["sign" =: sign]
  | otherwise = trWith "A comment begins with two dashes, not with ‘{sign}’." ["sign" =: sign]

isDashes :: Text -> Bool
isDashes = Text.all (`elem` ("-–—" :: String))

-- | The end of a sign. Two long dashes are two tokens.
signEnd :: [Token] -> Token -> Position
signEnd row t = maybe (tokenEnd t) tokenEnd (listToMaybe (reverse dashes))
  where
    dashes = takeWhile (\x -> from x >= from t && isDashes (word x)) (dropWhile ((< from t) . from) row)

-- | Whether a token is the sign of a comment. Takes what stands in front of it and behind it in its row.
isCommentSign :: Program -> [Token] -> Token -> [Token] -> Bool
isCommentSign p before t behind
  | word t `elem` ["–", "—"] = null before || (isProse && not isQuoted)
  | "--" `Text.isPrefixOf` word t && not (isDashes (word t)) || word t == "<!--" = null before || isProse
  | word t `elem` ["//", "#", "/*"] = not (null before) && isProse
  | otherwise = False
  where
    -- Between curly quotation marks it belongs to a text.
    isQuoted = Text.any (`elem` ("“”„‘’‚«»‹›" :: String)) (lineOf (source p) (line (from t)))
    -- The next word is one that the program has nowhere else.
    isProse = case [word b | b <- behind, not (isDashes (word b))] of
      [] -> False
      w : _ -> Text.all isAlpha w && length (filter ((== w) . word) (tokens p)) == 1 && w /= "pi"

-- | Comments between three quotation marks.
docstrings :: Program -> [Problem]
docstrings p =
  [ repaired p (tokenSpan t) "comment" (otherSign "\"\"\"") [Edit (Span (from t) (lineEnd t)) ("-- " <> Text.strip (Text.replace "\"\"\"" "" (lineText t)))]
    | t : _ <- rows p,
      "\"\"\"" `Text.isPrefixOf` lineText t
  ]
  where
    lineText t = lineOf (source p) (line (from t))
    lineEnd t = Position (line (from t)) (Text.length (lineText t) + 1)

-- | Steps of a @do@ with numbers or dashes in front.
numberedSteps :: Program -> [Problem]
numberedSteps p =
  [ repairedWith p (tokenSpan t) "syntax" (tr "The steps of a ‘do’ have no numbers or dashes in front.") (tr "Remove them.") removals
    | marked@((t, _) : _ : _) <- [mapMaybe markOf (rows p)],
      let removals = [Edit (Span (from a) (from b)) "" | (a, b) <- marked]
  ]
  where
    -- The mark, and the first token behind it.
    markOf row = case row of
      n : sign : b : _
        | column (from n) > 1, isWhole (word n), word sign `elem` [".", ")", ":"], isGlued n sign, isName (word b) -> Just (n, b)
      sign : b : _
        | column (from sign) > 1, word sign `elem` ["-", "*", "•"], not (isGlued sign b), isName (word b) -> Just (sign, b)
      _ -> Nothing

-- | Characters as the source of a web page writes them: @&gt;@ for @>@.
characterReferences :: Program -> [NumberedLine] -> [Problem]
characterReferences p ls =
  [ repaired p (replaces first) "syntax" (trWith "‘{word}’ comes from a web page, where it stands for ‘{sign}’." ["word" =: textAt (source p) (replaces first), "sign" =: by first]) es
    | es@(first : _) <- [concatMap inLine ls]
  ]
  where
    inLine (n, l) =
      [ Edit (Span (Position n at) (Position n (at + Text.length name))) new
        | (name, new) <- [("&gt;", ">"), ("&lt;", "<"), ("&amp;", "&"), ("&quot;", "\""), ("&#39;", "'"), ("&nbsp;", " ")],
          (before, _) <- Text.breakOnAll name l,
          let at = Text.length before + 1
      ]
