{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.TypeMismatches
-- Description : Explanations of types that differ from what is needed.
--
-- A rule for each cause, the most specific first. "Rosy.Worker.Explanation.MismatchCauses" has those whose cause is visible in the text. Pure.
module Rosy.Worker.Explanation.TypeMismatches
  ( explainMismatch,
  )
where

import Control.Applicative ((<|>))
import Data.Char (isAlphaNum, isLower, isSpace)
import Data.Foldable (asum)
import Data.List (find)
import Data.Maybe (fromMaybe, isJust, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.ArgumentCounts
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.Mismatch
import Rosy.Worker.Explanation.MismatchCauses (mismatchCause)
import Rosy.Worker.Explanation.MismatchRepairs
import Rosy.Worker.Explanation.RobotTypes (commandTypes, typesOfValues)
import Rosy.Worker.Explanation.RobotVocabulary
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

explainMismatch :: Mismatch -> Problem
explainMismatch m = fromMaybe (differentTypes m) (asum (map ($ m) rules))

-- | The first that applies explains the message.
rules :: [Rule]
rules =
  [ doneOutsideTask,
    endOfTaskDiffers,
    mainRunsNothing,
    infiniteType,
    mismatchCause,
    tooManyArguments,
    equationTakesMore,
    unneededReturn,
    tooFewArguments,
    maybeMissing,
    memoryMismatch,
    taskMismatch,
    conditionMismatch,
    numberOrText,
    listMismatch,
    lastArgumentMissing,
    sideMissing,
    textContinues,
    differentListElements,
    wrapperMissing,
    pairWithGenerator,
    nothingTaken,
    tooGeneral,
    functionNotApplied
  ]

differentTypes :: Mismatch -> Problem
differentTypes Mismatch {..} = problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (mismatchHint needed given)

-- * Definitions

-- | A function outside of all tasks gives Done.
doneOutsideTask :: Rule
doneOutsideTask Mismatch {..}
  | "NotInATask" `elem` [needed, given] = Just $ case blamed of
    Just f -> p {function = Just (called f), place = typePlace outline (called f) "Done" <|> place p}
    Nothing -> p
  | otherwise = Nothing
  where
    blamed = find (any ("Done" `Text.isPrefixOf`) . outputs) (connectedTo outline)
    p = problem "done-outside-task" (maybe (tr "This gives Done, but it is not part of a task.") (\f -> trWith "‘{function}’ gives Done, but it is not part of a task." ["function" =: called f]) blamed) (tr "Remove Done, or put the function into a task: task () f")

-- | A task ends with another type than its Done carries.
endOfTaskDiffers :: Rule
endOfTaskDiffers Mismatch {..}
  | Just u <- user, u `elem` ["task", "taskWith"], Just p <- endUsedElsewhere outline raw problem needed given = Just p
  | Just u <- user, u `elem` ["task", "taskWith"] = Just $ problem "done-type" (trWith "The task ends with {a needed}, but its Done carries {a given}." ["needed" =: needed, "given" =: given]) (if needed == "String" then tr "Make both the same, or turn what it ends with into a text with show." else tr "Make both the same type.")
  | otherwise = Nothing
  where
    user = listToMaybe . quotedParts =<< after "arising from a use of" messageText

-- | @main@ is no run of the robot.
mainRunsNothing :: Rule
mainRunsNothing Mismatch {..}
  | "IO" == firstAtom needed, "IO action ‘main’" `Text.isInfixOf` whole = Just $ problem "main-type" (tr "‘main’ must say what to do with the robot.") (trWith "Write: main = simulate {body}" ["body" =: mainBody])
  | otherwise = Nothing
  where
    mainBody = case source of
      _ | Just l <- mainLine, not ("simulate" `Text.isInfixOf` l), Text.length l < 40 -> asArgument l
      _ -> "f"
    asArgument l
      | "do" `elem` take 1 (Text.words l) = "$ " <> l
      | Text.any isSpace l && not ("(" `Text.isPrefixOf` l) && not ("[" `Text.isPrefixOf` l) = "(" <> l <> ")"
      | otherwise = l
    mainLine = fmap (Text.strip . Text.drop 1) (listToMaybe [snd (Text.breakOn "=" l) | l <- Text.lines (text outline), "main" `elem` take 1 (Text.words l)])

-- | A type would contain itself.
infiniteType :: Rule
infiniteType Mismatch {..}
  | "Occurs check" `Text.isInfixOf` messageText || isVariable needed && needed `elem` Text.words given || isVariable given && given `elem` Text.words needed = Just $ problem "infinite-type" (tr "This would have to contain itself.") (tr "Check the brackets, and whether a function is given to itself by accident.")
  | otherwise = Nothing

-- | @return@ in a function that is no task.
unneededReturn :: Rule
unneededReturn m@Mismatch {..}
  | "m" == firstAtom given, Just w <- firstWord m, w `elem` ["return", "pure"] = Just $ problem "type-mismatch" (trWith "A function gives its value without ‘{word}’." ["word" =: w]) (trWith "Remove ‘{word}’." ["word" =: w])
  | otherwise = Nothing

-- * Wrapped values and tasks

-- | One of the two types is a Maybe.
maybeMissing :: Rule
maybeMissing m@Mismatch {..}
  | needed == "Maybe " <> bracketIfNeeded given = Just $ problem "missing-just" (trWith "This always gives {a given}, but the type says that it may be missing." ["given" =: given]) (maybe (tr "Write Just in front of it.") (\code -> trWith "Write Just in front of it: {code}" ["code" =: code]) (example m "Just"))
  | given == "Maybe " <> bracketIfNeeded needed || "Maybe" == firstAtom given && "Maybe" /= firstAtom needed = Just $ problem "unexpected-maybe" (trWith "This may be nothing, but {a needed} is needed." ["needed" =: needed]) (trWith "Write the type as Maybe {type}, or give a value in every case." ["type" =: bracketIfNeeded needed])
  | otherwise = Nothing

-- | One of the two types is a Memory, or both are.
memoryMismatch :: Rule
memoryMismatch m@Mismatch {..}
  | "Memory" == firstAtom needed, "Memory" /= firstAtom given, not (isFunction given) = Just $ problem "missing-memory" (trWith "This is {a given}, but {a needed} is needed." ["given" =: given, "needed" =: needed]) (maybe (tr "Write Memory in front of the value.") (\code -> trWith "Write Memory in front of the value: {code}" ["code" =: code]) (example m "Memory"))
  | "Memory" == firstAtom given, "Memory" /= firstAtom needed, firstWord m == Just "Memory" = Just $ problem "memory-as-value" (trWith "This is a whole Memory, but the type says ‘{needed}’." ["needed" =: needed]) (trWith "Write the type as {given}" ["given" =: given])
  | "Memory" == firstAtom given,
    "Memory" /= firstAtom needed =
    Just $
      problem
        "memory-as-value"
        (trWith "This is a whole Memory, but the ‘{needed}’ in it is needed." ["needed" =: needed])
        ( case source of
            Just x | Text.all isAlphaNum x -> trWith "Take it out with a pattern: (Memory {name}) instead of {name}" ["name" =: x]
            _ -> tr "Take it out with a pattern: (Memory x) instead of x."
        )
  | "Memory" == firstAtom needed, "Memory" == firstAtom given = Just $ problem "memory-types" (trWith "This memory holds {a inside}, but one with {a wanted} is needed." ["inside" =: inner given, "wanted" =: inner needed]) (tr "Each memory has one type: use the same everywhere.")
  | otherwise = Nothing

-- | One of the two types is a Task, or both are.
taskMismatch :: Rule
taskMismatch m@Mismatch {..}
  | "Task" == firstAtom needed, "Task" == firstAtom given = Just $ problem "task-result" (trWith "This task ends with {a inside}, but one that ends with {a wanted} is needed." ["inside" =: stripBrackets (inner given), "wanted" =: stripBrackets (inner needed)]) (if stripBrackets (inner needed) == "()" then maybe (tr "If its result is not needed, write void in front of it.") (\s -> trWith "If its result is not needed, write void ({code})" ["code" =: s]) source else tr "The last line of a task gives its result.")
  | "Task" == firstAtom needed, Just own <- firstWord m, own `elem` map fst readyTasks, isJust (lookup own (bindings outline)) = Just $ problem "task-needed" (trWith "Here ‘{name}’ is your own function, which hides the ready-made task." ["name" =: own]) (tr "Give your function another name.")
  | "Task" == firstAtom needed = Just $ problem "task-needed" (trWith "A task is needed here, but this is {a given}." ["given" =: given]) (maybe (tr "Turn a command into a task with once.") (\code -> trWith "Turn a command into a task with once: {code}" ["code" =: code]) (example m "once"))
  | "Task" == firstAtom given, "IO" == firstAtom needed = Just $ problem "controller-needed" (tr "This is a task, but ‘main’ only says what to simulate.") (tr "Put all the steps after it: main = simulate (do …)")
  | "Task" == firstAtom given = Just $ problem "controller-needed" (trWith "This is a task, but {a needed} is needed here." ["needed" =: needed]) (tr "Start a task with simulate, or in another task with do.")
  | otherwise = Nothing

-- * Conditions, numbers, texts and lists

-- | A condition is not true or false.
conditionMismatch :: Rule
conditionMismatch Mismatch {..}
  | needed == "Bool", behindNot = Just $ problem "type-mismatch" (tr "‘not’ takes only what comes right after it.") (trWith "Put brackets around the comparison: {code}" ["code" =: ("not (" <> fromMaybe "a > b" comparison <> ")")])
  | needed == "Bool", "if" `Text.isInfixOf` whole = Just $ problem "type-mismatch" (trWith "The condition of an ‘if’ is true or false, but this is {a given}." ["given" =: given]) (maybe (tr "Compare it with something, for example with ==") (\code -> trWith "Compare it, for example: {code}" ["code" =: code]) (compared <$> source <*> listToMaybe [v | (v, t) <- typesOfValues, t == given || (t, given) == ("ButtonStatus", "BumperStatus")]))
  | Just code <- partCompared = Just $ problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (trWith "Compare it, for example: {code}" ["code" =: code])
  | otherwise = Nothing
  where
    behindNot = maybe False (\s -> "not" `elem` take 1 (reverse (Text.words (Text.take (column (start s) - 1) (lineAt outline s))))) (messageSpan raw)
    -- What stands behind not, up to the end of the condition.
    comparison = do
      s <- messageSpan raw
      let rest = Text.drop (column (start s) - 1) (lineAt outline s)
          found = Text.strip (foldr (\mark t -> fst (Text.breakOn mark t)) rest [" then", " =", " &&", " ||", ")"])
      if any (`Text.isInfixOf` found) [" > ", " < ", " == ", " /= ", " >= ", " <= "] && not ("(" `Text.isInfixOf` found) then Just found else Nothing
    compared x v = x <> " == " <> v
    -- b == Pressed, where b is the whole event.
    partCompared = do
      s <- messageSpan raw
      part <- source
      (sign, x) <- case reverse (map word (tokenize (Text.take (column (start s) - 1) (lineAt outline s)))) of
        e : v : _ -> Just (e, v)
        _ -> Nothing
      if needed `elem` eventsWithPlaces && sign `elem` ["==", "/="] && maybe False (isLower . fst) (Text.uncons x) && (isJust (lookup part typesOfValues) || part `elem` places)
        then Just (Text.toLower needed <> (if part `elem` places then (if needed == "Button" then "Number" else "Side") else "Status") <> " " <> x <> " " <> sign <> " " <> part)
        else Nothing

-- | Different kinds of numbers, or a text and a number.
numberOrText :: Rule
numberOrText m@Mismatch {..}
  | needed == "Double", given == "Int", Just p <- wholeNumbers outline raw problem = Just p
  | isNumber needed, isNumber given, needed /= given = Just $ problem "type-mismatch" (if given `elem` ["Int", "Integer"] then trWith "This is {a given}, a whole number, but {a needed} is needed." ["given" =: given, "needed" =: needed] else trWith "This is {a given}, but {a needed} is needed." ["given" =: given, "needed" =: needed]) (conversionHint needed given)
  | isNumber needed, given == "String" = Just $ problem "type-mismatch" (trWith "This is a text, but a number (‘{needed}’) is needed." ["needed" =: needed]) (tr "Numbers are written without quotation marks.")
  | needed == "String", isNumber given || given `elem` ["Bool", "Orientation"] = Just $ problem "type-mismatch" (trWith "This is {a given}, but a text is needed." ["given" =: given]) (maybe (tr "Turn it into a text with show.") (\code -> trWith "Turn it into a text with show: {code}" ["code" =: code]) (example m "show"))
  | otherwise = Nothing

-- | A list and one element.
listMismatch :: Rule
listMismatch Mismatch {..}
  | needed == "[" <> given <> "]" = Just $ problem "type-mismatch" (trWith "This is one ‘{given}’, but a list of them is needed." ["given" =: given]) (tr "Put it in square brackets.")
  | given == "[" <> needed <> "]" = Just $ problem "type-mismatch" (trWith "This is a list, but one ‘{needed}’ is needed." ["needed" =: needed]) (tr "Take one element of it.")
  | otherwise = Nothing

-- | A function lacks its last argument.
lastArgumentMissing :: Rule
lastArgumentMissing Mismatch {..}
  | isFunction given, not (isFunction needed), lastPart given == needed = Just $ problem "missing-argument" (trWith "Something is missing here: this still needs {a input}." ["input" =: firstPart given]) (tr "Add the missing value.")
  | otherwise = Nothing

-- | A value of one side of an Either.
sideMissing :: Rule
sideMissing m@Mismatch {..}
  | "Either" : l : r : _ <- typeAtoms needed, Just side <- lookup given [(l, "Left"), (r, "Right")] = Just $ problem "missing-side" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (maybe (tr "Say which of the two it is.") (\code -> trWith "Say which of the two it is: {code}" ["code" =: code]) (example m side))
  | otherwise = Nothing

-- | A text of Say goes on with ++.
textContinues :: Rule
textContinues Mismatch {..}
  | given == "String", needed == "Say", Just rest <- Text.stripPrefix "Say " =<< source, " ++ " `Text.isInfixOf` rest = Just $ problem "operator" (trWith "Only the first text belongs to this ‘{function}’." ["function" =: "Say"]) (trWith "Put brackets around all of the text: Say ({code})" ["code" =: rest])
  | given == "Say", needed == "String" || "[" `Text.isPrefixOf` needed = Just $ problem "operator" (trWith "Only the first text belongs to this ‘{function}’." ["function" =: "Say"]) (trWith "Put brackets around all of the text: Say ({code})" ["code" =: maybe "…" (Text.strip . snd . Text.breakOnEnd "Say ") (lineAt outline <$> messageSpan raw)])
  | otherwise = Nothing

-- | The parts of a list have different types.
differentListElements :: Rule
differentListElements Mismatch {..}
  | isFunction given && isFunction needed || all (`elem` commandTypes) [given, needed], Just p <- listOfDifferentTypes outline raw problem = Just p
  | otherwise = Nothing

-- | A constructor around the value is missing.
wrapperMissing :: Rule
wrapperMissing m@Mismatch {..}
  | Just c <- wrapperOf given needed = Just $ problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (maybe (trWith "Write {name} in front of it." ["name" =: c]) (\code -> trWith "Write {name} in front of it: {code}" ["name" =: c, "code" =: code]) (example m c))
  | otherwise = Nothing

-- | A random value together with its new generator.
pairWithGenerator :: Rule
pairWithGenerator m@Mismatch {..}
  | "(" `Text.isPrefixOf` given, "StdGen)" `Text.isSuffixOf` given = Just $ problem "type-mismatch" (trWith "This is a pair with a new generator, but {a needed} is needed here." ["needed" =: needed]) (maybe (tr "Take the first of the two.") (\code -> trWith "Take the first of the two: {code}" ["code" =: code]) (example m "fst"))
  | otherwise = Nothing

-- * Functions and type variables

-- | A definition takes less than its type says.
nothingTaken :: Rule
nothingTaken Mismatch {..}
  | isFunction needed, not (isFunction given), not (isVariable given) = Just $ problem "type-mismatch" (trWith "The type says that this takes {a input}, but nothing is taken here." ["input" =: firstPart needed]) (tr "Name what it takes on the left of the equals sign, or change the type.")
  | otherwise = Nothing

-- | A type variable stands for one type only.
tooGeneral :: Rule
tooGeneral Mismatch {..}
  | "rigid type variable" `Text.isInfixOf` whole = Just $ problem "too-general" (trWith "The type says that this works for any ‘{type}’, but it does not." ["type" =: (if isVariable needed then needed else given)]) (tr "Write the type that is meant instead of the small letter.")
  | otherwise = Nothing

-- | A function without its values.
functionNotApplied :: Rule
functionNotApplied Mismatch {..}
  | isFunction given, not (isFunction needed) = Just $ problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (tr "Give the function its values, or check the brackets.")
  | otherwise = Nothing

-- * Parts of the sentences

-- | A word in front of the part of the program, which is in brackets if it consists of several tokens.
example :: Mismatch -> Text -> Maybe Text
example Mismatch {..} f = (\s -> f <> " " <> (if Text.any (== ' ') s && not (Text.isPrefixOf "(" s) then "(" <> s <> ")" else s)) <$> source

-- | The word that what is wrong begins with.
firstWord :: Mismatch -> Maybe Text
firstWord m = listToMaybe . Text.words =<< source m

-- | What a function takes first.
firstPart :: Type -> Type
firstPart = fromMaybe "" . listToMaybe . splitArrows

-- | What a function gives.
lastPart :: Type -> Type
lastPart = fromMaybe "" . listToMaybe . reverse . splitArrows
