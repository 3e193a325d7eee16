{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TextualMistakes.Tasks
-- Description : Steps without @do@ or without semicolons, and wrong arguments of tasks and of @simulate@.
module Rosy.Worker.Explanation.TextualMistakes.Tasks
  ( tasks,
  )
where

import Data.List (nub, tails)
import Data.Maybe (fromMaybe, isJust, listToMaybe)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText (lineOf, textAt)
import Rosy.Worker.Explanation.RobotTypes (commandTypes)
import Rosy.Worker.Explanation.RobotVocabulary (readyTasks, taskSynonyms)
import Rosy.Worker.Explanation.TextRepair
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Several tasks in a row without @do@, tasks behind @forever@, and numbers for @repeat@.
tasks :: Program -> [Problem]
tasks p = concat [loops p, withoutElse p (rows p), methodCalls p, concatMap (directions p) behind, concatMap (negatives p) behind, concatMap (commandAssignments p) (rows p), concatMap (rightTurns p) behind, concatMap (sequences p) behind, blocks p (rows p), concatMap (numberOfRepeat p) (tails (rows p)), concatMap (emptyBrackets p) behind, concatMap (severalFunctions p) (rows p)]
  where
    behind = tails (tokens p)

-- | A task in a sequence: its first token, and where the one before it ends, unless it is the first.
type Step = (Token, Maybe Position)

-- | Ready-made tasks in a row. Takes the tokens from the one in front of the first on.
sequences :: Program -> [Token] -> [Problem]
sequences p ts = case ts of
  b : rest
    | word b `elem` ["(", "$", "do", "="],
      Just steps <- stepsOf rest,
      isSequence b steps ->
      [withoutDo p b steps]
  _ -> []
  where
    isSequence b steps = case word b of
      "do" -> all ((== line (from b)) . line . from . fst) steps && not (all isSeparated steps)
      "=" -> isMain b && isTogether steps
      _ -> isTogether steps
    isTogether steps = isColumn steps || length (nub (map (line . from . fst) steps)) == 1
    isSeparated (t, before) = maybe True (\e -> Text.strip (textAt (source p) (Span e (from t))) == ";") before
    isMain b = or [word m == "main" && from e == from b | m : e : _ <- rows p]

-- | Whether each step stands on a line of its own, all in one column.
isColumn :: [Step] -> Bool
isColumn steps = length (nub (map (column . from . fst) steps)) == 1 && length (nub (map (line . from . fst) steps)) == length steps

-- | Two or more tasks in a row, perhaps with signs of other languages in between.
stepsOf :: [Token] -> Maybe [Step]
stepsOf rest = case rest of
  t : more | isTask t, following@(_ : _) <- stepsBehind (lastArgument t more) -> Just ((t, Nothing) : following)
  _ -> Nothing
  where
    stepsBehind (before, following) = case following of
      t : more | isTask t -> (t, Just (tokenEnd before)) : stepsBehind (lastArgument t more)
      s : t : more | isSeparator s, isTask t -> (t, Just (tokenEnd before)) : stepsBehind (lastArgument t more)
      _ -> []
    isSeparator s = word s `elem` ["then", "and", "+", "->", "&", "&&", ";", "=>", ">"]

isTask :: Token -> Bool
isTask t = isJust (lookup (word t) readyTasks)

-- | The last token of a task with its argument, and what follows.
lastArgument :: Token -> [Token] -> (Token, [Token])
lastArgument t more = case more of
  a : rest
    | takesOne, isNumeral (word a) || isName (word a) && not (isTask a) -> (a, rest)
    | takesOne, word a == "(", (_, c : rest') <- break ((== ")") . word) rest -> (c, rest')
  _ -> (t, more)
  where
    takesOne = lookup (word t) readyTasks == Just 1

-- | The problem with steps behind a token, with the signs that separate them.
withoutDo :: Program -> Token -> [Step] -> Problem
withoutDo p b steps
  | word b == "do" = repaired p inLine "syntax" (maybe (tr "Between two steps on one line goes a semicolon.") (\w -> trWith "Between two steps on one line goes a semicolon, not ‘{word}’." ["word" =: w]) separator) separated
  | not (isColumn steps) = repaired p inLine "syntax" (maybe needsDo (\w -> trWith "Several steps in a row need ‘do’ in front and semicolons between them, not ‘{word}’." ["word" =: w]) separator) (Edit (nothingAt (from first)) (simulated <> "do ") : separated)
  | line (from b) < line (from first) = repairedWith p firstLine "syntax" needsDo below (Edit (nothingAt (tokenEnd b)) ((if word b == "(" then "" else " ") <> simulated <> "do") : ended)
  | otherwise = repairedWith p firstLine "syntax" needsDo below (Edit (nothingAt (from first)) (simulated <> "do\n" <> Text.replicate (column (from first) - 1) " ") : ended)
  where
    first = fst (head' steps)
    head' = foldr const (b, Nothing)
    inLine = Span (from first) (tokenEnd (lastOf (fst (last steps))))
    lastOf t = fst (lastArgument t (drop 1 (dropWhile ((< from t) . from) (tokens p))))
    -- A word or sign of another language between two steps.
    separator = listToMaybe [word s | (t, Just e) <- steps, s <- tokens p, e <= from s, from s < from t, word s /= ";"]
    firstLine = spanOf first (fromMaybe first (listToMaybe (reverse [y | y <- tokens p, line (from y) == line (from first), from y >= from first])))
    simulated = if word b == "=" then "simulate $ " else ""
    separated = [Edit (Span e (from s)) "; " | (s, Just e) <- steps]
    -- Removes what stands behind a step on its line, but for a comment.
    ended =
      [ Edit (Span e e {column = column e + Text.length rest}) ""
        | (s, Just e) <- steps,
          line e < line (from s),
          let rest = Text.drop (column e - 1) (lineOf (source p) (line e)),
          not (Text.null (Text.strip rest)),
          not ("--" `Text.isPrefixOf` Text.strip rest)
      ]
    needsDo = if Text.null simulated then tr "Several steps in a row need ‘do’ in front." else tr "‘main’ needs ‘simulate’, and several steps in a row need ‘do’ in front."
    below = if Text.null simulated then tr "Write do, and below it each step on a line of its own." else trWith "Write {code}, and below it each step on a line of its own." ["code" =: ("main = " <> simulated <> "do")]

-- | Indented steps behind @forever@ or @replicateM_ 4@ without @do@.
blocks :: Program -> [[Token]] -> [Problem]
blocks p rest = case rest of
  row@(f : _) : next@((n : _) : _)
    | column (from n) > column (from f),
      Just loop <- loopAtEnd (reverse row),
      l : _ <- reverse row ->
      repaired p (spanOf loop l) "missing-do" (trWith "After ‘{word}’, before its steps, comes ‘do’." ["word" =: word loop]) [Edit (nothingAt (tokenEnd l)) " $ do"] : blocks p next
  _ : next -> blocks p next
  [] -> []
  where
    loopAtEnd reversed = case reversed of
      l : _ | word l == "forever" -> Just l
      n : l : _ | isWhole (word n), word l `elem` ["replicateM_", "replicateM"] -> Just l
      _ -> Nothing

-- | A turn to the right, which has no name of its own.
rightTurns :: Program -> [Token] -> [Problem]
rightTurns p ts = case ts of
  r : n : _
    | word r == "right",
      isNumeral (word n) || isName (word n),
      line (from r) == line (from n),
      null [f | f : _ <- rows p, column (from f) == 1, word f == "right"] ->
      [repaired p (spanOf r n) "not-in-scope" (tr "‘right’ is turn with a negative number.") [Edit (spanOf r n) ("turn (-" <> word n <> ")")]]
  _ -> []

-- | @repeat 4@. Takes the rows from the one where it stands on: steps may stand below it.
numberOfRepeat :: Program -> [[Token]] -> [Problem]
numberOfRepeat p below = case below of
  row@(f : _) : rest ->
    [ repaired p (spanOf t n) "too-many-arguments" (tr "‘repeat’ goes on for ever, and takes no number.") (Edit (tokenSpan t) "replicateM_" : [Edit (nothingAt (tokenEnd n)) " $ do" | null more, s : _ <- take 1 rest, column (from s) > column (from f)])
      | t : n : more <- tails row,
        word t `elem` ["repeat", "Repeat"],
        isWhole (word n)
    ]
  _ -> []

-- | Tasks as methods of a robot, as other languages write them: @robot.drive(50)@, @time.sleep(1)@. One problem for all of the same object.
methodCalls :: Program -> [Problem]
methodCalls p =
  [ repaired p (spanOf o m) "operator" (trWith "‘{function}’ is written alone, without ‘{word}’ in front." ["function" =: ours, "word" =: (word o <> ".")]) [Edit (spanOf x y) new | (x, y, new) <- calls, word x == word o]
    | (o, m, ours) : _ <- map (\n -> [c | c@(x, _, _) <- calls, word x == n]) (nub [word x | (x, _, _) <- calls])
  ]
  where
    calls =
      [ (o, m, ours)
        | o : d : m : a : _ <- tails (tokens p),
          isName (word o) && word d == "." && isGlued o d && isGlued d m,
          word a == "(" && isGlued m a || isNumeral (word a) || word a == "\"",
          word o `notElem` [word f | f : _ <- rows p, column (from f) == 1],
          Just ours <- [if isTask m then Just (word m) else lookup (word m) (filter ((/= "simulate") . snd) taskSynonyms)]
      ]

-- | A direction behind @turn@ or @drive@: @turn left 90@.
directions :: Program -> [Token] -> [Problem]
directions p ts = case ts of
  t : a : b : _
    | Just (message', signs) <- lookup (word t) directed,
      [d, n] <- if isNumeral (word a) then [b, a] else [a, b],
      isNumeral (word n),
      all ((== line (from t)) . line . from) [a, b],
      Just isBack <- lookup (Text.toLower (word d)) signs,
      null [f | f : _ <- rows p, column (from f) == 1, word f `elem` [word t, word d]] ->
      [repaired p (spanOf t (if from a < from b then b else a)) "too-many-arguments" message' [Edit (spanOf a b) (if isBack then "(-" <> word n <> ")" else word n)]]
  _ -> []
  where
    directed =
      [ ("turn", (tr "‘turn’ takes degrees alone: to the left, and with a minus to the right.", [(w, False) | w <- Text.words "left links gauche izquierda esquerda"] ++ [(w, True) | w <- Text.words "right rechts droite derecha direita"])),
        ("drive", (tr "‘drive’ takes centimetres alone: ahead, and with a minus back.", [(w, False) | w <- Text.words "forward forwards ahead vorwärts avant adelante frente"] ++ [(w, True) | w <- Text.words "back backward backwards rückwärts arrière atrás trás"]))
      ]

-- | A negative number without brackets behind a task: @turn -90@.
negatives :: Program -> [Token] -> [Problem]
negatives p ts = case ts of
  t : m : n : _
    | lookup (word t) readyTasks == Just 1,
      word m == "-",
      isNumeral (word n),
      isGlued m n,
      line (from t) == line (from n) ->
      [repaired p (spanOf m n) "negative-number" (tr "A negative number needs brackets.") [Edit (spanOf m n) ("(-" <> word n <> ")")]]
  _ -> []

-- | A command with an equals sign among the steps of a task: @Led1 = Green@.
commandAssignments :: Program -> [Token] -> [Problem]
commandAssignments p row = case row of
  c : e : v : _
    | column (from c) > 1,
      word c `elem` commandTypes,
      word e == "=",
      l : _ <- reverse row ->
      [repaired p (spanOf c e) "definition" (tr "Among the steps of a task, a command stands behind ‘once’, without an equals sign.") [Edit (Span (from c) (from v)) ("once (" <> word c <> " "), Edit (nothingAt (tokenEnd l)) ")"]]
  _ -> []

-- | Brackets of a call in other languages behind a name that takes nothing.
emptyBrackets :: Program -> [Token] -> [Problem]
emptyBrackets p ts = case ts of
  t : o : z : _
    | word o == "(",
      word z == ")",
      isGlued t o,
      isGlued o z,
      lookup (word t) readyTasks == Just 0 || word t == "main" && column (from t) > 1 ->
      [repaired p (spanOf t z) "too-many-arguments" (trWith "‘{function}’ is written alone, without brackets after it." ["function" =: word t]) [Edit (spanOf o z) ""]]
  _ -> []

-- | Several functions behind @simulate@ that are no tuple.
severalFunctions :: Program -> [Token] -> [Problem]
severalFunctions p row =
  [ repaired p whole "too-many-arguments" (message' (filter isWord arguments)) [Edit whole ("(" <> Text.intercalate ", " (map word names) <> ")")]
    | (_, _ : arguments@(a : _ : _)) <- [break ((== "simulate") . word) row],
      let names = filter (not . isSeparator) arguments,
      length names > 1,
      all ((`elem` defined) . word) names,
      length arguments `elem` [length names, 2 * length names - 1],
      let whole = spanOf a (last names)
  ]
  where
    isSeparator t = isWord t || word t == ","
    isWord t = word t `elem` ["and", "+", "&", "&&"]
    message' separators = case separators of
      t : _ -> trWith "Several functions go in brackets with commas, without ‘{word}’." ["word" =: word t]
      [] -> tr "Several functions go in brackets with commas."
    defined = nub [word f | f : _ <- rows p, column (from f) == 1, isName (word f)]

-- | Loops of Python among the steps of a task that Haskell's own replace: @while True:@, @for i in range(4):@ whose name is not used.
loops :: Program -> [Problem]
loops p =
  [ repaired p (spanOf w c) "word" (trWith "Haskell has no loop called ‘{word}’." ["word" =: word w]) [Edit (spanOf w c) new]
    | row@(w : more) <- rows p,
      column (from w) > 1,
      c : _ <- [reverse row],
      Just new <- [replacement (map word more) w]
  ]
  where
    replacement ws w = case ws of
      ["True", ":"] | word w == "while" -> Just "forever $ do"
      [i, "in", "range", "(", n, ")", ":"] | word w == "for", isWhole n, length (filter ((== i) . word) [t | t <- tokens p, chunkOf p (line (from t)) == chunkOf p (line (from w))]) == 1 -> Just ("replicateM_ " <> n <> " $ do")
      _ -> Nothing

-- | A step @if loud then say "hey"@ without @else@. Takes the rows from the first on.
withoutElse :: Program -> [[Token]] -> [Problem]
withoutElse p below = case below of
  row@(i : _) : rest
    | word i == "if",
      (condition@(_ : _), t : task@(s : _)) <- break ((== "then") . word) (drop 1 row),
      all ((`notElem` ["else", "if", "do"]) . word) task,
      isBalanced (map word task),
      -- The next line is another step.
      all (\next -> column (from next) <= column (from i) && word next `notElem` ["else", "then"]) (concatMap (take 1) (take 1 rest)),
      isStepOfDo i,
      behind <- Text.strip (Text.drop (column (from s) - 1) (lineOf (source p) (line (from s)))),
      not ("--" `Text.isInfixOf` behind),
      code <- Text.unwords ["when", bracketed condition (Text.strip (textAt (source p) (Span (tokenEnd i) (from t)))), bracketed task behind] ->
      repairedWith p (tokenSpan i) "missing-else" (tr "This ‘if’ has no ‘else’.") (trWith "For a step that is left out otherwise, write: {code}" ["code" =: code]) [Edit (Span (from i) (Position (line (from i)) (Text.length (Text.stripEnd (lineOf (source p) (line (from i)))) + 1))) code] : withoutElse p rest
  _ : rest -> withoutElse p rest
  [] -> []
  where
    bracketed ts written = if length ts == 1 then written else "(" <> written <> ")"
    isBalanced ws = length (filter (== "(") ws) == length (filter (== ")") ws)
    -- The nearest line above that is further to the left ends with do.
    isStepOfDo i = or [word l == "do" | row <- take 1 (reverse [row | row@(f : _) <- rows p, line (from f) < line (from i), column (from f) < column (from i)]), l : _ <- [reverse row]]
