{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.ArgumentCounts
-- Description : Explanations of calls and equations with too many or too few values.
--
-- Rules of "Rosy.Worker.Explanation.TypeMismatches". Pure.
module Rosy.Worker.Explanation.ArgumentCounts
  ( tooManyArguments,
    equationTakesMore,
    tooFewArguments,
  )
where

import Control.Applicative ((<|>))
import Data.Char (isDigit)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.Mismatch
import Rosy.Worker.Explanation.RobotTypes (sensedOnly)
import Rosy.Worker.Explanation.RobotVocabulary
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | A function is given more values than it takes.
tooManyArguments :: Rule
tooManyArguments m = excess m <$> argumentsIn (whole m)

-- | The function, how many values it is given, how many it takes.
argumentsIn :: Text -> Maybe (Text, Int, Text)
argumentsIn whole = do
  rest <- after "The function ‘" whole <|> after "The data constructor ‘" whole <|> after "The constructor ‘" whole
  taken <- countOf =<< between "is applied to " " value argument" rest
  Just (Text.takeWhile (/= '’') rest, taken, fromMaybe "none" (between "has only" "|" (Text.replace " In " "|" rest)))

excess :: Mismatch -> (Text, Int, Text) -> Problem
excess Mismatch {..} (f, taken, has)
  | overLines = problem "indentation" (tr "The next line seems to go on with this one.") (tr "Lines of one block begin in the same column.")
  -- As in wait 2 seconds, where ‘seconds’ is a field.
  | Just s <- source,
    [_, n, unit] <- Text.words s,
    Text.all isDigit (Text.takeEnd 1 n),
    Just advice <- unitHint unit =
    (problem "unit" (tr "A number is written without its unit.") advice) {place = fmap (\w -> w {start = Position (line (end w)) (column (end w) - Text.length unit)}) (messageSpan raw)}
  | f == "simulate", Just s <- source, t : v : _ <- drop 1 (Text.words s), Text.all (`elem` ("0123456789.\"" :: String)) (Text.take 1 v) = problem "too-many-arguments" (tr "‘simulate’ takes one thing only.") (trWith "Put brackets around what belongs together: simulate ({code})" ["code" =: Text.unwords [t, v]])
  | f == "simulate" = problem "too-many-arguments" (tr "‘simulate’ takes one thing only.") (tr "Put several functions into brackets with commas: simulate (f, g)")
  | f `elem` ["once", "task", "taskWith", "call"] = problem "too-many-arguments" (if f == "once" then tr "‘once’ takes one thing only." else trWith "‘{function}’ takes two things." ["function" =: f]) (tr "Put brackets around what belongs together, for example: once (Velocity 0.5 0)")
  | f == "repeat" = problem "too-many-arguments" (tr "‘repeat’ goes on for ever, and takes no number.") (tr "To do a task several times, write: replicateM_ 4 (say \"hello\")")
  | f == "randomR" = problem "too-many-arguments" (tr "‘randomR’ takes both ends as one pair, and a generator.") (tr "Write: fst (randomR (0, 1) gen)")
  | f == "show", Just s <- source, (n, quote) <- Text.breakOn " \"" (Text.drop 5 s), not (Text.null quote) = problem "operator" (tr "Only the first value belongs to this ‘show’.") (trWith "Between two texts goes ++: {code}" ["code" =: "show " <> n <> " ++" <> quote])
  | "none" == has, Just s <- source, "simulate" `elem` Text.words (maybe "" (lineAt outline) (messageSpan raw)), not (Text.any (`elem` ("()" :: String)) s) = problem "too-many-arguments" (trWith "‘{function}’ takes no values, but is given {count taken}." ["function" =: f, "taken" =# taken]) (trWith "If these are several functions, put commas between them: ({code})" ["code" =: Text.intercalate ", " (Text.words s)])
  | "none" == has || "has none" `Text.isInfixOf` whole = problem "too-many-arguments" (trWith "‘{function}’ takes no values, but is given {count taken}." ["function" =: f, "taken" =# taken]) (tr "Remove what is too much, or check the brackets.")
  | otherwise = problem "too-many-arguments" (trWith "‘{function}’ is given {count taken} values, which is too many." ["function" =: f, "taken" =# taken]) (tr "Remove what is too much, or put brackets around what belongs together.")
  where
    overLines = maybe False (\s -> line (start s) < line (end s)) (messageSpan raw) && "do" `Text.isInfixOf` whole

-- | An equation has more patterns than its type has arrows.
equationTakesMore :: Rule
equationTakesMore Mismatch {..}
  | Just f <- equationsTooLong = Just $ problem "argument-count" (trWith "‘{function}’ takes more than its type says." ["function" =: f]) (takenHint outline f (messageSpan raw))
  | otherwise = Nothing
  where
    equationsTooLong = do
      rest <- after "The equation(s) for ‘" whole <|> after "The equation for ‘" whole <|> after "The equations for ‘" whole
      if any (`Text.isInfixOf` rest) ["has none", "has only"] then Just (Text.takeWhile (/= '’') rest) else Nothing

-- | A function is given fewer values than it takes.
tooFewArguments :: Rule
tooFewArguments Mismatch {..}
  | "too few arguments" `Text.isInfixOf` whole = missingArgument <$> appliedTooLittle
  | otherwise = Nothing
  where
    appliedTooLittle = listToMaybe . quotedParts =<< after "Probable cause:" whole
    missingArgument f
      | f `elem` ["return", "pure"] || f == "Done" && needed == "Done ()" = problem "missing-argument" (trWith "‘{function}’ needs the value that it gives." ["function" =: f]) (trWith "If there is none, write: {function} ()" ["function" =: f])
      | f == "call" = problem "missing-argument" (tr "‘call’ needs two things: a task, and what to do with it.") (tr "Write callOptions after the task.")
      | not (null missing), any isVariable missing = problem "missing-argument" (if length missing == 1 then trWith "‘{function}’ needs another value." ["function" =: f] else trWith "‘{function}’ needs {count n} more values." ["function" =: f, "n" =# length missing]) (tr "Add what is missing.")
      | not (null missing) = problem "missing-argument" (if length missing == 1 then trWith "‘{function}’ needs another value: {then types}." ["function" =: f, "types" =* missing] else trWith "‘{function}’ needs {count n} more values: {then types}." ["function" =: f, "n" =# length missing, "types" =* missing]) (tr "Add what is missing.")
      | otherwise = problem "missing-argument" (trWith "‘{function}’ needs more values than it is given." ["function" =: f]) (tr "Add what is missing.")
      where
        parts = splitArrows given
        missing = take (length parts - length (splitArrows needed)) parts

-- | What to add to the type of a function whose equation has more patterns than the type has arrows.
takenHint :: ProgramOutline -> Text -> Maybe Span -> Sentence
takenHint outline f at = case (sequence added, lookup f (signatures outline)) of
  _ | [t] <- parts, t `elem` sensedOnly, take 1 (map typeOfPattern patterns) `elem` [[Just t], [Nothing]] -> trWith "Add to the type what it gives: {code}" ["code" =: (f <> " :: " <> t <> " -> …")]
  (Just ts, Just _) | not (null ts) -> trWith "Add to the type what it takes: {code}" ["code" =: written ts]
  (Nothing, Just _) -> trWith "Add to the type what it takes, for example: {code}" ["code" =: written (map (fromMaybe "Bumper") added)]
  _ -> tr "Add to the type what it takes."
  where
    parts = maybe [] (maybe [] splitArrows . after "::" . oneLine . textAt (text outline)) (lookup f (signatures outline))
    written ts = f <> " :: " <> Text.intercalate " -> " (take (length parts - 1) parts ++ ts ++ drop (length parts - 1) parts)
    added = map typeOfPattern (drop (length parts - 1) patterns)
    patterns = case dropWhile (\t -> maybe True (from t <) (start <$> at)) (tokenize (text outline)) of
      t : rest | word t == f -> splitPatterns (takeWhile ((`notElem` ["=", "|"]) . word) rest)
      _ -> []
    splitPatterns ts = case ts of
      [] -> []
      t : rest
        | word t `elem` ["(", "["] -> let (inside, behind) = closing (1 :: Int) rest in map word (t : inside) : splitPatterns behind
        | otherwise -> [word t] : splitPatterns rest
    closing n ts = case ts of
      [] -> ([], [])
      t : rest
        | word t `elem` [")", "]"] && n == 1 -> ([t], rest)
        | otherwise -> let (inside, behind) = closing (if word t `elem` ["(", "["] then n + 1 else if word t `elem` [")", "]"] then n - 1 else n) rest in (t : inside, behind)
    typeOfPattern ws = case ws of
      ["(", ")"] -> Just "()"
      "(" : c : _ | c `elem` withParts -> Just c
      _ -> Nothing
    withParts = eventsWithPlaces ++ ["Velocity", "Position", "Orientation"]
