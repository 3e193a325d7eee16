{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.MissingInstances
-- Description : Explanations of types without a class that their use needs.
--
-- Covers what the robot cannot sense or be commanded, what cannot be remembered, shown or compared, and what one cannot calculate with.
module Rosy.Worker.Explanation.MissingInstances
  ( MissingInstance,
    missingInstanceOf,
    explainInstance,
  )
where

import Control.Applicative ((<|>))
import Data.Char (isAlphaNum, isDigit, isLower, isUpper)
import Data.Foldable (asum)
import Data.List (nub, tails)
import Data.Maybe (fromMaybe, isJust, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.AmbiguousTypes (feedbackOfWhat, unclear)
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.MismatchCauses (partialConstructor, unbracketedCalculation)
import Rosy.Worker.Explanation.RobotTypes (commandOnly, sensedOnly)
import Rosy.Worker.Explanation.RobotVocabulary
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | A message about a missing instance.
data MissingInstance = MissingInstance
  { outline :: ProgramOutline,
    raw :: CompilerMessage,
    problem :: Say,
    className :: Text,
    -- | The type without an instance.
    lacking :: Type,
    -- | The same type as programs write it: a text is a list of characters.
    written :: Type,
    -- | The expression that requires it.
    user :: Text,
    -- | The line of the program that the message is about.
    here :: Text
  }

-- | Takes the class, the type, and the expression that requires the instance.
missingInstanceOf :: ProgramOutline -> CompilerMessage -> Say -> Text -> Type -> Text -> MissingInstance
missingInstanceOf outline raw problem className lacking user = MissingInstance {..}
  where
    written = if lacking == "Char" then "String" else lacking
    here = maybe "" (lineAt outline) (messageSpan raw)

type Rule = MissingInstance -> Maybe Problem

explainInstance :: MissingInstance -> Problem
explainInstance m = fromMaybe (otherInstance m) (asum (map ($ m) rules))

-- | The first that applies explains the message.
rules :: [Rule]
rules = [openType, tooLargeTuple, taskWithoutEnd, notSensed, countedTexts, notCommanded, notMemorable, wrongBrackets, functionAsValue, notDerived, notANumber]

-- * Rules

-- | It is not said of which type a value is.
openType :: Rule
openType MissingInstance {..}
  | className == "Typeable", lacking == "feed" = Just $ feedbackOfWhat problem
  | className `elem` ["Typeable", "Value", "Default"], isOpenType lacking, user == "simulate" = Just $ unclear outline problem
  | otherwise = Nothing

-- | A tuple of inputs, outputs or controllers is too large.
tooLargeTuple :: Rule
tooLargeTuple MissingInstance {..}
  | className `elem` ["Sensor", "Command", "Controller", "Runnable"], parts <- tupleParts lacking, length parts > largestTuple = Just $ largeTuple outline raw problem (length parts)
  | otherwise = Nothing

-- | It is not known with what a task ends.
taskWithoutEnd :: Rule
taskWithoutEnd MissingInstance {..}
  | className == "Typeable", isOpenType lacking, "Done" `elem` Text.words (Text.map (\x -> if isAlphaNum x then x else ' ') (text outline)) = Just $ problem "ambiguous-type" (tr "It is not clear with what this task ends.") (endHint outline (messageSpan raw))
  | className == "Typeable", isOpenType lacking = Just $ problem "ambiguous-type" (tr "This task has no end: none of its functions gives Done.") (tr "Give Done () when it is over; if it goes on for ever, say so: (task start go :: Task ())")
  | otherwise = Nothing

-- | A function takes what the robot cannot sense.
notSensed :: Rule
notSensed m@MissingInstance {..}
  | className == "Sensor", Just (f, _) <- culprit m inputs, any ("Task" `Text.isPrefixOf`) (outputs f) = Just $ problem "missing-argument" (trWith "‘{function}’ needs a value before it is a task." ["function" =: called f]) (trWith "Give it one: simulate ({function} …)" ["function" =: called f])
  | className == "Sensor", Just (f, _) <- culprit m inputs, Just (k, s) <- partialConstructor outline (called f) = Just $ (problem "missing-argument" (trWith "‘{function}’ needs another value: {then types}." ["function" =: k, "types" =* [lacking]]) (addMissing k)) {function = Just (called f), place = Just s}
  | className == "Sensor", isNumber lacking, Nothing <- culprit m inputs, k : _ <- Text.words (Text.dropWhile (`elem` ("($ " :: String)) (fromMaybe "" (after "simulate" here))), isUpper (Text.head k) = Just $ problem "missing-argument" (trWith "‘{function}’ needs another value: {then types}." ["function" =: k, "types" =* [lacking]]) (addMissing k)
  | className == "Sensor" = Just $ blaming m inputs (problem "not-a-sensor" (maybe (trWith "This takes {a type}, which the robot cannot sense." ["type" =: lacking]) (\f -> trWith "‘{function}’ takes {a type}, which the robot cannot sense." ["function" =: f, "type" =: lacking]) (owner m)) (sensorHint m))
  | otherwise = Nothing

-- | Texts are given where numbers are counted.
countedTexts :: Rule
countedTexts MissingInstance {..}
  | className == "Enum", lacking == "String" = Just $ problem "calculation" (tr "Here numbers are counted, but texts are needed.") (tr "Turn each number into a text with show: (say . show)")
  | otherwise = Nothing

-- | A function gives what is no command.
notCommanded :: Rule
notCommanded m@MissingInstance {..}
  | className == "Command", "Task" `Text.isPrefixOf` lacking, any isOpenType (drop 1 (typeAtoms lacking)) = Just $ problem "missing-controller" (tr "‘task’ needs two things: how it starts, and what it does.") (tr "If nothing is to be done first, write: task () f")
  | className == "Command", "Task" `Text.isPrefixOf` lacking = Just $ blaming m outputs (problem "controller-needed" (maybe (tr "This is a task, but here a function for the robot is needed.") (\f -> trWith "‘{function}’ is a task, but here a function for the robot is needed." ["function" =: f]) (owner m)) (callHint m))
  | className == "Command", "IO" `Text.isPrefixOf` lacking = Just $ problem "not-a-command" (tr "This is for the computer, not for the robot.") (tr "To show a text, give Say; in a task, write say.")
  | className `elem` ["Command", "Controller"], written == "String" = Just $ blaming m outputs (problem "not-a-command" (givesNoCommand m "String") (tr "To show a text, write Say in front of it."))
  | className `elem` ["Command", "Controller", "Runnable"] = Just $ blaming m outputs (problem "not-a-command" (givesNoCommand m lacking) (commandHint m))
  | otherwise = Nothing

-- | A memory or an event cannot hold a type.
notMemorable :: Rule
notMemorable MissingInstance {..}
  | className == "Default", isJust (lookup (fromMaybe lacking (listToMaybe (typeAtoms lacking))) (bindings outline)) = Just $ problem "not-memorable" (trWith "A ‘{type}’ has no value that a memory could start with." ["type" =: lacking]) (trWith "Remember a list of them, which starts empty: Memory [{type}]" ["type" =: lacking])
  | className == "Default" = Just $ problem "not-memorable" (trWith "A ‘{type}’ cannot be remembered." ["type" =: lacking]) (tr "Memory holds numbers, texts, lists, and types of your own.")
  | className == "Value" = Just $ problem "not-memorable" (trWith "A ‘{type}’ cannot be kept or sent." ["type" =: lacking]) (tr "Events and memories hold numbers, texts, lists, and types of your own.")
  | otherwise = Nothing

-- | A calculation or a negative number has no brackets.
wrongBrackets :: Rule
wrongBrackets m@MissingInstance {..}
  | Just (k, sum') <- unbracketedCalculation here, className `elem` ["Num", "Fractional"], isFunction lacking || lacking == k = Just $ problem "operator" (tr "A calculation among other values needs brackets.") (trWith "Write it as ({code})" ["code" =: sum'])
  | isFunction lacking, user == "-", "Num" == className = Just $ problem "negative-number" (tr "Here minus takes one thing from another.") (trWith "A negative number needs brackets: (-{number})" ["number" =: subtrahend m])
  | otherwise = Nothing

-- | A function is used like a value.
functionAsValue :: Rule
functionAsValue MissingInstance {..}
  | className == "Show", isFunction lacking = Just $ problem "function-as-value" (tr "A function cannot be shown as a text.") (tr "Give it its values first.")
  | isFunction lacking = Just $ problem "function-as-value" (trWith "Here a value is needed, but this is {a type}." ["type" =: lacking]) (tr "Give the function its values, or check the brackets.")
  | otherwise = Nothing

-- | A declared type derives no class for it.
notDerived :: Rule
notDerived MissingInstance {..}
  | className == "Show" = Just $ problem "missing-deriving" (trWith "It is not known how to show {a type} as a text." ["type" =: lacking]) (tr "Write at the end of its declaration: deriving Show")
  | className == "Eq" = Just $ problem "missing-deriving" (trWith "It is not known when two values of ‘{type}’ are equal." ["type" =: lacking]) (tr "Write at the end of its declaration: deriving Eq")
  | className == "Ord" = Just $ problem "missing-deriving" (trWith "It is not known which value of ‘{type}’ is the larger." ["type" =: lacking]) (tr "Write at the end of its declaration: deriving (Eq, Ord)")
  | otherwise = Nothing

-- | A type is not of the kind of numbers that is needed, or no number at all.
notANumber :: Rule
notANumber m@MissingInstance {..}
  | className `elem` ["Num", "Fractional", "Floating", "Integral", "RealFrac"], lacking == "String", user == "+" = Just $ problem "type-mismatch" (tr "Texts cannot be added with +.") (tr "To join them, write ++.")
  | className `elem` ["Fractional", "Floating", "RealFrac"], lacking `elem` ["Int", "Integer"] = Just $ problem "type-mismatch" (trWith "A whole number (‘{type}’) cannot hold what this gives." ["type" =: lacking]) (tr "Turn it into a Double with fromIntegral, or divide with div.")
  | className `elem` ["Integral", "Bits"] = Just $ problem "type-mismatch" (trWith "A whole number is needed here, but this is {a type}." ["type" =: lacking]) (tr "Turn it into one with round or truncate.")
  | className `elem` ["Num", "Fractional"], "literal" `Text.isInfixOf` whole, Just memory <- rememberedNumber m = Just $ problem "type-mismatch" (trWith "There is a number, but the type says ‘{type}’." ["type" =: lacking]) (if lacking == "Bool" then trWith "Write the type as {given}, or True or False in place of the number." ["given" =: memory] else trWith "Write the type as {given}, or {a type} in place of the number." ["given" =: memory, "type" =: lacking])
  | className `elem` ["Num", "Fractional"], "literal" `Text.isInfixOf` whole = Just $ problem "type-mismatch" (trWith "There is a number where {a type} is needed." ["type" =: lacking]) (numberMismatchHint lacking)
  | className `elem` ["Num", "Fractional", "Floating"] = Just $ problem "calculation" (trWith "With {a type} one cannot calculate." ["type" =: lacking]) (calculationHint m)
  | otherwise = Nothing
  where
    whole = oneLine (Text.unwords (important raw))

otherInstance :: MissingInstance -> Problem
otherInstance MissingInstance {..}
  | className `elem` ["Monad", "Applicative", "Functor", "MonadFail", "Foldable", "Traversable"] = problem "type-mismatch" (trWith "‘{type}’ cannot be used with ‘{function}’." ["type" =: lacking, "function" =: user]) (tr "Check which value was meant.")
  | otherwise = problem "type-mismatch" (trWith "A ‘{type}’ cannot be used with ‘{function}’." ["type" =: lacking, "function" =: user]) (if ("class " <> className) `Text.isInfixOf` text outline then trWith "Say what it does for it: declare it for ‘{type}’ as well." ["type" =: lacking] else tr "Check which value was meant.")

-- * Parts of the sentences

isOpenType :: Type -> Bool
isOpenType = maybe False (isLower . fst) . Text.uncons

-- | What stands behind the minus sign.
subtrahend :: MissingInstance -> Text
subtrahend MissingInstance {..} = case filter (not . Text.null) [Text.takeWhile (\x -> isAlphaNum x || x `elem` ("._'" :: String)) (Text.stripStart (Text.drop 2 behind)) | (_, behind) <- Text.breakOnAll " -" here] of
  n : _ -> n
  [] -> "1"

-- | Behind Memory, in a function whose type has memories of this type only: the type that the number has.
rememberedNumber :: MissingInstance -> Maybe Type
rememberedNumber MissingInstance {..} = do
  s <- messageSpan raw
  f <- enclosing outline s
  signature <- lookup f (signatures outline)
  let memories = [w | name : w : _ <- tails (map word (tokenize (textAt (text outline) signature))), name == "Memory"]
      behindMemory = take 1 (reverse (Text.words (Text.take (column (start s) - 1) here))) `elem` [["Memory"], ["(Memory"]]
  if behindMemory && not (null memories) && all (== lacking) memories then Just (if "." `Text.isInfixOf` textAt (text outline) s then "Memory Double" else "Memory Int") else Nothing

calculationHint :: MissingInstance -> Sentence
calculationHint MissingInstance {..}
  | lacking `elem` ["Velocity", "Position", "Pose"] = tr "Take its numbers out with a pattern, as in (Velocity v w), and put them together again."
  | "Memory" `Text.isPrefixOf` lacking = tr "Take out what it holds with a pattern: (Memory n)"
  | Text.null user = tr "Check which value was meant."
  | otherwise = trWith "‘{function}’ works on numbers only." ["function" =: user]

givesNoCommand :: MissingInstance -> Type -> Sentence
givesNoCommand m given = maybe (trWith "This gives {a type}, which is not a command." ["type" =: given]) (\f -> trWith "‘{function}’ gives {a type}, which is not a command." ["function" =: f, "type" =: given]) (owner m)

-- | The function whose type has it, and how its type is written there.
culprit :: MissingInstance -> (Function -> [Type]) -> Maybe (Function, Type)
culprit MissingInstance {..} which = listToMaybe (filter isHere candidates ++ candidates)
  where
    isHere (f, _) = messageSpan raw == lookup (called f) (bindings outline)
    candidates = [(f, as) | (f, full) <- zip (connectedTo outline) (spelledOut outline), (as, x) <- zip (which f) (map simplifyType (which full)), x `elem` [lacking, written]]

-- | The function that takes or gives the type.
blamed :: MissingInstance -> Maybe (Function, Type)
blamed m@MissingInstance {..} = culprit m (if className == "Sensor" then inputs else outputs)

owner :: MissingInstance -> Maybe Text
owner m = called . fst <$> blamed m

-- | Moves a problem to the type of the function that it is about.
blaming :: MissingInstance -> (Function -> [Type]) -> Problem -> Problem
blaming m@MissingInstance {..} which p = case culprit m which of
  Just (f, as) -> p {function = Just (called f), place = typePlace outline (called f) as <|> place p}
  Nothing -> p

-- | How the task of a function is started beside it, in the program's own words.
callHint :: MissingInstance -> Sentence
callHint m@MissingInstance {..} = case blamed m of
  Just (f, _)
    | Just ts <- splitArrows <$> lookup (called f) (typesOfNames outline) ->
      trWith "Give a Call: {code}, and in it call ({task}) callOptions." ["code" =: called f <> " :: " <> Text.intercalate " -> " (init ts ++ ["Call"]), "task" =: fromMaybe "…" (bodyOf (called f))]
  _ -> tr "A function starts a task beside itself with call: call (…) callOptions"
  where
    bodyOf f = do
      s <- lookup f (bindings outline)
      body <- after "=" (textAt (text outline) s)
      if "\n" `Text.isInfixOf` body || Text.length body > 40 then Nothing else Just (Text.strip body)

sensorHint :: MissingInstance -> Sentence
sensorHint MissingInstance {..}
  | isFunction lacking = tr "A function can take events, states and memories, but no functions."
  | "Task" `Text.isPrefixOf` lacking = tr "Tasks are started with do or with call."
  | "[" `Text.isPrefixOf` lacking || lacking == "String" = trWith "To remember one between firings, take Memory {type}" ["type" =: bracketIfNeeded lacking]
  | lacking `elem` ["Int", "Integer", "Double", "Float", "Bool", "Char"] = trWith "To remember one between firings, take Memory {type}" ["type" =: lacking]
  | lacking `elem` commandOnly = tr "It can only be commanded."
  | otherwise = tr "Take something that happens or a Memory, or declare a type of your own."

commandHint :: MissingInstance -> Sentence
commandHint MissingInstance {..}
  | isFunction lacking = tr "Give the inner function its values."
  | lacking `elem` ["Int", "Integer", "Double", "Float"] = trWith "To drive, give a Velocity; to remember the number, give Memory {type}" ["type" =: lacking]
  | lacking == "Bool" = tr "To remember it for other functions, give Memory Bool."
  | lacking `elem` ["Seconds", "StdGen", "Clock"] || lacking `elem` sensedOnly = tr "It can only be sensed."
  | otherwise = tr "Give a command such as Velocity, a Memory, or a type of your own."

-- | The type to write above a task without one, where what its Done carries shows it.
endHint :: ProgramOutline -> Maybe Span -> Sentence
endHint outline at = case nub [carried rest | d : rest <- tails (filter isInside found), word d == "Done"] of
  [Just t] | Just f <- plainName -> trWith "Write the type of the task above it, for example: {code}" ["code" =: (f <> " :: Task " <> t)]
  _ -> tr "Write the type of the task above it: Task, and behind it the type of what its Done carries."
  where
    found = tokenize (text outline)
    own = [s | Just a <- [at], (_, s) <- bindings outline, start s <= start a, end a <= end s]
    ofOwn = [t | t <- found, s <- own, start s <= from t, from t < end s]
    isInside t = "Done" `notElem` map word ofOwn || t `elem` ofOwn
    -- The task itself, unless it takes something.
    plainName = listToMaybe [word f | f : e : _ <- [ofOwn], word e == "="]
    carried rest = case map word (take 3 rest) of
      "(" : ")" : _ -> Just "()"
      "\"" : _ -> Just "String"
      w : dot : n : _ | isDigits w, dot == ".", isDigits n -> Just "Double"
      w : _
        | isDigits w -> Just "Int"
        | w `elem` ["True", "False"] -> Just "Bool"
      _ -> Nothing
    isDigits w = not (Text.null w) && Text.all isDigit w

-- | The most parts of a tuple of inputs, outputs or controllers (rules R14 to R16).
largestTuple :: Int
largestTuple = 9

-- | A tuple with more parts than that.
largeTuple :: ProgramOutline -> CompilerMessage -> Say -> Int -> Problem
largeTuple outline raw problem size = problem "large-tuple" (trWith "A tuple here has at most {count most} parts, and this one has {count size}." ["most" =# largestTuple, "size" =# size]) hint'
  where
    marked = maybe "" (textAt (text outline)) (messageSpan raw)
    -- From GHC 9.4 on the function alone is underlined, and the tuple stands behind it.
    behind = maybe "" (\s -> Text.drop (column (end s) - 1) (lineOf (text outline) (line (end s)))) (messageSpan raw)
    hint' = case tupleParts (Text.dropWhile (/= '(') (if Text.any (== '(') marked then marked else Text.stripEnd behind)) of
      names | length names == size, (firstOnes, rest) <- splitAt (largestTuple - 1) names -> trWith "Put the last ones into a tuple of their own: ({code})" ["code" =: Text.intercalate ", " (take 1 firstOnes ++ ["…", "(" <> Text.intercalate ", " rest <> ")"])]
      _ -> tr "Put some of them into a tuple of their own: (a, b, (c, d))"
