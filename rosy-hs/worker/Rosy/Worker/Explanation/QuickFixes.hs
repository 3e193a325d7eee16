{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.QuickFixes
-- Description : Quick fixes of problems, as text edits.
--
-- Takes an explained problem, the program and the compiler message. A fix that would need a guess at the intention is not offered; a value
-- that is still to be chosen is a hole, @_@. Pure.
module Rosy.Worker.Explanation.QuickFixes
  ( quickFixes,
    nearMisses,
  )
where

import Data.Char (isAlphaNum, isSpace)
import Data.List (find)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.ImportSuggestions (moduleExporting, moduleForAlias)
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.MissingCases (OpenGuards (..), functionWithEquations, openGuards, unmatchedPatterns)
import Rosy.Worker.Explanation.OriginalVocabulary (oneTypeForTask, originalNameFixes)
import Rosy.Worker.Explanation.RobotVocabulary (loopWords, readyTasks, robotNames, rosySpelling)
import Rosy.Worker.Explanation.TextRepair (capitalised)
import Rosy.Worker.Explanation.Tokenizer (Token (..), tokenEnd, tokenSpan, tokenize)
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | The fixes of a problem, the most likely first.
quickFixes :: ProgramOutline -> CompilerMessage -> Problem -> [Fix]
quickFixes outline raw p = case (kind p, place p) of
  (unknown, Just s) | unknown `elem` ["not-in-scope", "operator"], found@(_ : _) <- originalNameFixes source s -> found
  ("unknown-field", Just s) -> originalNameFixes source s
  ("type-argument", Just s) | "takes one type" `Text.isInfixOf` english (message p) -> oneTypeForTask source s
  ("not-in-scope", Just at) ->
    let s = withoutBackticks source at
     in map (spelled s) (take 3 (maybe (if textAt source s `elem` ("right" : loopWords) then [] else nearMisses everything (textAt source s)) pure (rosySpelling (textAt source s)))) ++ imports source s
  ("missing-definition", Just s) -> map (spelled s) (take 1 (nearMisses everything (textAt source s))) ++ equation outline s
  ("hole", Just s) -> [Fix (trWith "Fill in {name}" ["name" =: n]) [Edit s n] | n <- fitting p]
  ("missing-cases", Just s) -> missingCases outline raw s
  ("bracket", Just s) -> brackets source p s
  ("controller-needed", Just s) | "Give a Call" `Text.isPrefixOf` english (hint p) -> startedWithCall outline p s
  ("missing-quote", Just s) -> [Fix (tr "Close the text") [Edit (nothingAt (endOfText source s)) "\""]]
  ("missing-just", Just s) -> [Fix (tr "Write Just in front") [Edit s ("Just " <> bracketed (textAt source s))]]
  ("negative-number", Just s) -> negative source s
  ("comparison", Just s) -> [Fix (tr "Compare with ==") [Edit s "=="]]
  ("missing-arrow", Just s) -> [Fix (tr "Write an arrow") [Edit s (if textAt source s == "," then " ->" else "->")]]
  ("missing-colon", Just s) -> [Fix (tr "Write two colons") [Edit s "::"]]
  ("missing-equals", Just s) | "sign is missing." `Text.isSuffixOf` english (message p) -> [Fix (tr "Write =") [Edit (nothingAt (end s)) " ="]]
  ("word", Just s) | "a dollar sign is missing" `Text.isInfixOf` english (message p) -> [Fix (tr "Write a dollar sign") [Edit (nothingAt (start s)) "$ "]]
  ("missing-equals", Just s) | textAt source s == "->" -> [Fix (tr "Write =") [Edit s "="]]
  ("missing-let", Just s) -> [Fix (trWith "Write {code}" ["code" =: "let"]) [Edit (nothingAt (start s)) "let "]]
  ("field-value", Just s) -> [Fix (tr "Write =") [Edit s "="]]
  ("definition", Just s) -> [Fix (tr "Write =") [Edit s "="]]
  ("comment", Just s) -> [Fix (tr "Write --") [Edit s "--"]]
  ("missing-where", Just s) -> [Fix (tr "Add where") [Edit (nothingAt (end s)) " where"]]
  ("word", Just s) | textAt source s `elem` ["elif", "elsif", "elseif"] -> [Fix (tr "Write else if") [Edit (tokenSpan t) "else if" | t <- tokenize source, word t == textAt source s]]
  ("lower-case-type", Just s) -> [Fix (trWith "Write {code}" ["code" =: n]) [Edit s n] | n <- [capitalised (textAt source s)], n `elem` robotNames, not (isRepeated source s)]
  ("guard", Just s) | textAt source s == "=", guardsFollow source s -> [Fix (trWith "Remove {code}" ["code" =: "="]) [Edit s ""]]
  ("type-mismatch", _) -> fixes p
  ("done-type", _) -> fixes p
  ("pattern", _) -> fixes p
  ("tab", _) -> [Fix (tr "Write spaces for all tabs") (tabs source) | not (null (tabs source))]
  _ -> []
  where
    source = text outline
    everything = oneLine (Text.unwords (important raw ++ context raw ++ supplementary raw))
    spelled s n = Fix (trWith "Write {code}" ["code" =: n]) [Edit s n]

-- * Names

-- | Whether a word stands elsewhere as well: one capital letter leaves another name as it is.
isRepeated :: Text -> Span -> Bool
isRepeated source s = length [t | t <- tokenize source, word t == textAt source s] /= 1

-- | Names that fit a hole: the hint lists them already.
fitting :: Problem -> [Text]
fitting p = maybe [] quotedParts (after "for example " (english (hint p)))

-- | A function used as an operator is reported with its backticks.
withoutBackticks :: Text -> Span -> Span
withoutBackticks source s@(Span begin stop)
  | "`" `Text.isPrefixOf` textAt source s = Span begin {column = column begin + 1} stop {column = column stop - 1}
  | otherwise = s

imports :: Text -> Span -> [Fix]
imports source s =
  [ Fix (trWith "Import {name}" ["name" =: what]) [Edit (nothingAt (importPlace source)) (line' <> "\n")]
    | (what, line') <- case Text.breakOnEnd "." (textAt source s) of
        (q, _) | not (Text.null q) -> [(m, "import qualified " <> m <> " as " <> q') | q' <- [Text.dropEnd 1 q], Just m <- [moduleForAlias q']]
        (_, n) -> [(n, "import " <> m <> " (" <> n <> ")") | Just m <- [moduleExporting n]]
  ]

-- | An equation for a type without a definition.
equation :: ProgramOutline -> Span -> [Fix]
equation outline s =
  [ Fix (trWith "Define {name}" ["name" =: n]) [Edit (nothingAt (end whole)) ("\n" <> n <> Text.replicate (arrows n) " _" <> " = _")]
    | n <- [textAt source s],
      Just whole <- [lookup n (signatures outline)]
  ]
  where
    source = text outline
    arrows n = maybe 0 (\whole -> length (splitArrows (fromMaybe "" (after "::" (oneLine (textAt source whole))))) - 1) (lookup n (signatures outline))

-- * Texts and signs

-- | Before the brackets that were opened on the line before the text, and are closed at its end.
endOfText :: Text -> Span -> Position
endOfText source s =
  let before = Text.take (column (start s) - 1) (lineOf source (line (start s)))
      open = Text.count "(" before - Text.count ")" before
      closed = Text.length (Text.takeWhileEnd (== ')') (textAt source s))
   in (end s) {column = column (end s) - max 0 (min open closed)}

-- | Whether the first guard behind this has an equals sign of its own.
guardsFollow :: Text -> Span -> Bool
guardsFollow source s = case dropWhile ((<= start s) . from) (tokenize source) of
  bar : rest -> word bar == "|" && "=" `elem` takeWhile (`notElem` ["|", "->"]) (map word rest)
  [] -> False

-- | Spaces for each tab of the program.
tabs :: Text -> [Edit]
tabs source = [Edit (Span (Position l c) (Position l (c + 1))) (Text.replicate (width l c) " ") | (l, t) <- zip [1 ..] (Text.lines source), c <- tabsIn t]
  where
    tabsIn t = [c | (c, '\t') <- zip [1 ..] (Text.unpack t)]
    -- A tab goes on to the next column after a multiple of eight.
    width l c = 8 - (foldl' advance 0 (take (c - 1) (Text.unpack (lineOf source l))) `mod` 8)
    advance n '\t' = n + 8 - n `mod` 8
    advance n _ = n + 1 :: Int
    foldl' f z xs = foldr (\x k acc -> k $! f acc x) id xs z

-- | Brackets around a negative number.
negative :: Text -> Span -> [Fix]
negative source s =
  let rest = Text.drop (column (start s) - 1) (lineOf source (line (start s)))
      (sign, behind) = Text.splitAt (column (end s) - column (start s)) rest
      gap = Text.takeWhile isSpace behind
      value = Text.takeWhile (\c -> isAlphaNum c || c `elem` ("._'" :: String)) (Text.dropWhile isSpace behind)
      upto = (end s) {column = column (end s) + Text.length gap + Text.length value}
   in [Fix (tr "Put brackets around it") [Edit (Span (start s) upto) ("(" <> sign <> value <> ")")] | sign == "-", not (Text.null value)]

-- * Missing cases

missingCases :: ProgramOutline -> CompilerMessage -> Span -> [Fix]
missingCases outline raw s = withLastGuard ++ (if isMultiWayIf then [] else maybe (alternatives raw (text outline) s) (equations outline raw s) (functionWithEquations raw))
  where
    withLastGuard = [Fix (tr "Add a last guard") [Edit (nothingAt (endOfGuards g)) ("\n" <> Text.replicate (guardColumn g - 1) " " <> "| otherwise " <> separator g <> " _")] | Just g <- [openGuards outline raw]]
    isMultiWayIf = "multi-way if" `Text.isInfixOf` oneLine (Text.unwords (important raw ++ context raw ++ supplementary raw))

-- | The missing cases, if the list of them is complete and every pattern can be written as reported.
writableCases :: CompilerMessage -> Maybe [Text]
writableCases raw = if not (null missing) && all writable missing then Just missing else Nothing
  where
    missing = unmatchedPatterns raw
    writable m = not (" where " `Text.isInfixOf` m) && m /= "..."

-- | More equations of a function.
equations :: ProgramOutline -> CompilerMessage -> Span -> Text -> [Fix]
equations outline raw s name =
  let begin = maybe (start s) start (lookup name (bindings outline))
      n = arity (text outline) begin
      left ps = "\n" <> Text.replicate (column begin - 1) " " <> name <> " " <> ps <> " = _"
      whole m = if n == 1 then bracketed m else m
   in [Fix (tr "Add the missing cases") [Edit (nothingAt (end s)) (Text.concat (map (left . whole) missing))] | n > 0, Just missing <- [writableCases raw]]
        ++ [Fix (tr "Add a case for everything else") [Edit (nothingAt (end s)) (left (Text.unwords (replicate n "_")))] | n > 0]

-- | More alternatives of a case.
alternatives :: CompilerMessage -> Text -> Span -> [Fix]
alternatives raw source s = case filter (not . Text.null . Text.strip) (map (lineOf source) [line (start s) + 1 .. line (end s)]) of
  first : _ ->
    let indent = Text.takeWhile isSpace first
        right m = "\n" <> indent <> m <> " -> _"
     in [Fix (tr "Add the missing cases") [Edit (nothingAt (end s)) (Text.concat (map right missing))] | Just missing <- [writableCases raw]]
          ++ [Fix (tr "Add a case for everything else") [Edit (nothingAt (end s)) (right "_")]]
  [] -> []

-- * Tasks and brackets

-- | The task of a function with one equation, started beside it.
startedWithCall :: ProgramOutline -> Problem -> Span -> [Fix]
startedWithCall outline p s =
  [ Fix (tr "Start it with call") [Edit s "Call", Edit (nothingAt (from body)) "call (", Edit (nothingAt (end whole)) ") callOptions"]
    | "Task" `Text.isPrefixOf` textAt source s,
      Just f <- [function p],
      Just whole <- [lookup f (bindings outline)],
      let inside = [t | t <- tokenize source, from t >= start whole, from t < end whole],
      all ((`notElem` ["|", "where"]) . word) inside,
      [_, body : _] <- [splitOnEquals inside]
  ]
  where
    source = text outline
    splitOnEquals ts = case break ((== "=") . word) ts of
      (before, _ : behind) -> before : splitOnEquals behind
      (before, []) -> [before]

-- | A bracket that is never closed, of another kind, or never opened.
brackets :: Text -> Problem -> Span -> [Fix]
brackets source p s =
  let here = textAt source s
      found = tokenize source
      opened = find ((== start s) . from) found
   in case opened of
        Just t
          | "never closed" `Text.isInfixOf` english (message p) -> [Fix (trWith "Add {bracket}" ["bracket" =: closing here]) [Edit (nothingAt (closingPlace t (dropWhile ((<= from t) . from) found))) (closing here)]]
          | Just wanted <- listToMaybe (quotedParts (english (hint p))), "closes a bracket" `Text.isInfixOf` english (message p) -> [Fix (trWith "Write {code}" ["code" =: wanted]) [Edit s wanted]]
          | otherwise -> [Fix (trWith "Remove {code}" ["code" =: here]) [Edit s ""] | complete (takeWhile ((< from t) . from) found)]
        Nothing -> []

-- | Whether a definition may end behind these: with a value, and without a comma outside of brackets, which asks for the opening one.
complete :: [Token] -> Bool
complete before = case reverse before of
  t : _ -> (Text.all isNamed (word t) || word t `elem` [")", "]", "}", "\""]) && not (loose (0 :: Int) (reverse before))
  [] -> False
  where
    isNamed c = isAlphaNum c || c `elem` ("_'" :: String)
    -- From the last token back to the one at the left edge.
    loose _ [] = False
    loose n (t : ts)
      | n == 0, word t == "," = True
      | column (from t) == 1 = False
      | word t `elem` [")", "]", "}"] = loose (n + 1) ts
      | word t `elem` ["(", "[", "{"] = loose (n - 1) ts
      | otherwise = loose n ts

-- | Similar names suggested by GHC.
nearMisses :: Text -> Text -> [Text]
nearMisses everything unknownName = case filter ((== Text.toLower unknownName) . Text.toLower) (robotNames ++ (if "type constructor or class" `Text.isInfixOf` everything then [] else map fst readyTasks) ++ similar) of
  exact : _ | exact /= "error" -> [exact]
  _ -> filter (/= "error") similar
  where
    similar = foldr keep [] (maybe [] quotedParts (after "Perhaps you meant" everything))
    keep n ns = if n == unknownName || n `elem` ns || Text.all (== ' ') n then ns else n : ns

nothingAt :: Position -> Span
nothingAt at = Span at at

-- | In brackets, if it consists of several tokens.
bracketed :: Text -> Text
bracketed t
  | Text.any isSpace t && not (Text.isPrefixOf "(" t && enclosed (Text.unpack t)) = "(" <> t <> ")"
  | otherwise = t
  where
    -- The bracket that opens it closes only at its end.
    enclosed = go (0 :: Int)
    go n ('(' : cs) = go (n + 1) cs
    go 1 (')' : cs) = null cs
    go n (')' : cs) = go (n - 1) cs
    go n (_ : cs) = go n cs
    go _ [] = False

-- | Number of patterns of the equation at a position.
arity :: Text -> Position -> Int
arity source at = count (0 :: Int) (drop 1 (dropWhile ((< at) . from) (tokenize source)))
  where
    count _ [] = 0
    count 0 (t : _) | word t `elem` ["=", "|"] = 0
    count n (t : ts)
      | word t `elem` ["(", "["] = (if n == 0 then 1 else 0) + count (n + 1) ts
      | word t `elem` [")", "]"] = count (n - 1) ts
      -- @x\@p@ is one pattern.
      | n == 0, word t == "@" = count n ts - 1
      | n == 0 = 1 + count n ts
      | otherwise = count n ts

closing :: Text -> Text
closing "(" = ")"
closing "[" = "]"
closing _ = "}"

-- | Likely position of a missing closing bracket: before a token that cannot be in brackets, or at the end of the indented lines.
closingPlace :: Token -> [Token] -> Position
closingPlace open = go (tokenEnd open) (0 :: Int)
  where
    go at _ [] = at
    go at n (t : ts)
      | line (from t) > line at, column (from t) <= column (from open) = at
      | n == 0, word t `elem` ["=", "|", "->", "<-", "::", "then", "else", "of", "where"] = at
      | word t `elem` ["(", "[", "{"] = go (tokenEnd t) (n + 1) ts
      | word t `elem` [")", "]", "}"] = go (tokenEnd t) (max 0 (n - 1)) ts
      | otherwise = go (tokenEnd t) n ts

-- | Above the first import, or below what comes before all imports.
importPlace :: Text -> Position
importPlace source = Position (maybe (1 + header) fst (find (Text.isPrefixOf "import " . snd) numbered)) 1
  where
    numbered = zip [1 ..] (Text.splitOn "\n" source)
    header = length (takeWhile isHeader (Text.splitOn "\n" source))
    isHeader l = any (`Text.isPrefixOf` l) ["{-# LANGUAGE", "{-# OPTIONS", "module "]
