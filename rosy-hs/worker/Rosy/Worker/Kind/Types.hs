{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind.Types
-- Description : Types that do not fit, and what was probably meant.
--
-- Two families of messages: one type is needed and another is there; and a type cannot do what is asked of it (be
-- sensed, be a command, be shown, be added). Each has the cases that robot programs invite, and a plain sentence for the rest.
module Rosy.Worker.Kind.Types
  ( explainTypes,
  )
where

import Control.Applicative ((<|>))
import Data.Char (isAlphaNum, isLower, isSpace, isUpper)
import Data.List (find)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Kind.Nouns
import Rosy.Worker.Kind.Slips
import Rosy.Worker.Kind.Words
import Rosy.Worker.Problem
import Rosy.Worker.Raw

explainTypes :: Outline -> Raw -> Maybe Problem
explainTypes outline raw =
  (ambiguous said >>= \(v, c, user) -> Just (explainAmbiguous outline problem v c user))
    <|> (if "Overlapping instances for Runnable" `Text.isPrefixOf` said then Just (unclear outline problem) else Nothing)
    <|> (noInstance said >>= \(c, t, user) -> Just (explainInstance outline raw problem c t user))
    <|> (mismatch said >>= \(needed, given) -> Just (explainMismatch outline raw problem needed given))
    <|> (if "rigid type variable" `Text.isInfixOf` said then Just (problem "too-general" "The type promises more than the definition keeps." "Write the type that it really has.") else Nothing)
  where
    said = scrub (flat (Text.unwords (important raw)))
    problem k m h = Problem (gravity raw) k (region raw) Nothing m h "" []

type Say = Text -> Text -> Text -> Problem

-- * Reading

-- | The type that is needed and the one that is there.
mismatch :: Text -> Maybe (Type, Type)
mismatch said
  | Just rest <- after "Expected:" said,
    "Couldn't match" `Text.isPrefixOf` said =
    let (needed, more) = Text.breakOn "Actual:" rest
     in Just (typeIn needed, typeIn (upToNote (Text.drop 7 more)))
  | Just rest <- after "Couldn't match expected type" said =
    let (needed, more) = Text.breakOn "with actual type" rest
     in Just (typeIn (colon needed), typeIn (upToNote (colon (Text.drop 16 more))))
  | Just rest <- after "Couldn't match type" said,
    needed : given : _ <- quotes rest =
    Just (simple needed, simple given)
  | otherwise = Nothing
  where
    colon t = Text.strip (fromMaybe t (Text.stripPrefix ":" (Text.strip t)))
    upToNote t = foldr (\mark x -> fst (Text.breakOn mark x)) t ["‘’", " arising from", " Type synonyms", " The type variable", " because type"]

-- | Class, type, and what needs it.
noInstance :: Text -> Maybe (Text, Type, Text)
noInstance said = do
  rest <- after "No instance for (" said
  let inside = bracketed rest
      (c, t) = Text.breakOn " " inside
      user = maybe "" (\x -> fromMaybe (Text.takeWhile (/= ' ') x) (listToMaybe (quotes x))) (after "arising from" said)
  Just (c, simple (stripBrackets (Text.strip t)), user)

bracketed :: Text -> Text
bracketed = go (0 :: Int) ""
  where
    go depth acc rest = case Text.uncons rest of
      Just (')', _) | depth == 0 -> acc
      Just (x, more)
        | x `elem` ("([" :: String) -> go (depth + 1) (Text.snoc acc x) more
        | x `elem` (")]" :: String) -> go (depth - 1) (Text.snoc acc x) more
        | otherwise -> go depth (Text.snoc acc x) more
      Nothing -> acc

stripBrackets :: Text -> Text
stripBrackets t = case Text.stripPrefix "(" t >>= Text.stripSuffix ")" of
  Just inner | inner == bracketed inner, "," `notElemOuter` inner, not (Text.null inner) -> inner
  _ -> t
  where
    notElemOuter c x = not (c `Text.isInfixOf` x)

-- | Type variable, class, and what needs it.
ambiguous :: Text -> Maybe (Text, Text, Text)
ambiguous said = do
  rest <- after "Ambiguous type variable" said
  let names = quotes rest
      v = fromMaybe "" (listToMaybe names)
      c = maybe "" (Text.takeWhile (/= ' ')) (after "the constraint ‘(" rest)
      user = fromMaybe "" (listToMaybe (drop 1 names))
  Just (v, c, user)

-- * It is not clear which type

explainAmbiguous :: Outline -> Say -> Text -> Text -> Text -> Problem
explainAmbiguous outline problem v c user
  | letter == "feed" = feedbackOfWhat problem
  | Text.length letter > 2 = blamedFor letter (problem "lower-case-type" (quoted letter <> " stands for any type, because it begins with a small letter.") ("Write the type with a capital letter: " <> capital letter <> "."))
  | c `elem` ["Sensor", "Command", "Controller", "Runnable", "Ends"] = unclear outline problem
  | user `elem` ["read", "fromIntegral", "realToFrac"] = problem "ambiguous-type" ("It is not clear which type " <> quoted user <> " gives here.") "Say it, for example: (read \"1\" :: Double)."
  | otherwise = problem "ambiguous-type" "It is not clear which type this value has." "Say it behind the value, for example: (1 :: Double)."
  where
    letter = Text.dropWhileEnd (`elem` ("0123456789" :: String)) v
    capital t = Text.toUpper (Text.take 1 t) <> Text.drop 1 t
    blamedFor t p = case [(called f, s) | f <- connectedTo outline, Just s <- [typePlace outline (called f) t]] of
      (f, s) : _ -> p {function = Just f, place = Just s}
      [] -> p

-- | What is done with feedback leaves open of which type it is.
feedbackOfWhat :: Say -> Problem
feedbackOfWhat problem = problem "ambiguous-type" "It is not clear of which type this feedback is." "Say it where it is taken, for example: \\x -> Say (show (x :: Double))."

-- | A function whose type leaves open what it senses or gives.
unclear :: Outline -> Say -> Problem
unclear outline problem = case find (any isOpen . (\f -> inputs f ++ outputs f)) (connectedTo outline) of
  Just f ->
    let p = problem "ambiguous-type" (quoted (called f) <> " does not say what it senses or gives.") ("Write its type above it, for example: " <> called f <> " :: Bumper -> Maybe Sound.")
     in p {function = Just (called f), place = lookup (called f) (bindings outline) <|> place p}
  Nothing | Just w <- looseForever -> problem "too-many-arguments" "‘forever’ takes only what stands right behind it." ("Put brackets around the task: forever (" <> w <> ").")
  Nothing -> problem "ambiguous-type" "This does not say what it senses or gives." "Write its type above it, for example: f :: Bumper -> Maybe Sound."
  where
    -- forever say "x"
    looseForever = listToMaybe [rest | l <- Text.lines (text outline), Just more <- [after "forever " l], let rest = Text.strip (Text.takeWhile (`notElem` (")" :: String)) more), w : _ : _ <- [Text.words rest], maybe False (isLower . fst) (Text.uncons w), w /= "do", not ("$" `Text.isInfixOf` rest)]
    isOpen = any (maybe False (isLower . fst) . Text.uncons) . atoms

-- * A type cannot do something

explainInstance :: Outline -> Raw -> Say -> Text -> Type -> Text -> Problem
explainInstance outline raw problem c t user
  | c == "Typeable", t == "feed" = feedbackOfWhat problem
  | c == "Typeable", isOpenType t, "Done" `elem` Text.words (Text.map (\x -> if isAlphaNum x then x else ' ') (text outline)) = problem "ambiguous-type" "It is not clear with what this task ends." "Write the type of the task above it, for example: turn :: Task ()."
  | c == "Typeable", isOpenType t = problem "ambiguous-type" "This task has no end: none of its functions gives Done." "Give Done () when it is over; if it goes on for ever, say so: (task start go :: Task ())."
  | c == "Sensor", Just (f, _) <- culprit inputs, any ("Task" `Text.isPrefixOf`) (outputs f) = problem "missing-argument" (quoted (called f) <> " needs a value before it is a task.") ("Give it one: simulate (" <> called f <> " …).")
  | c == "Enum", t == "String" = problem "calculation" "Here numbers are counted, but texts are needed." "Turn each number into a text with show: (say . show)."
  | c == "Sensor", Just (f, _) <- culprit inputs, Just (k, s) <- halfBuilt outline (called f) = (problem "missing-argument" (quoted k <> " needs another value: " <> a t <> ".") "Add what is missing.") {function = Just (called f), place = Just s}
  | c == "Sensor", isNumber t, Nothing <- culprit inputs, k : _ <- Text.words (Text.dropWhile (`elem` ("($ " :: String)) (fromMaybe "" (after "simulate" here))), isUpper (Text.head k) = problem "missing-argument" (quoted k <> " needs another value: " <> a t <> ".") "Add what is missing."
  | c == "Sensor" = blaming inputs (problem "not-a-sensor" (who "takes" <> a t <> ", which the robot cannot sense.") sensorHint)
  | c == "Command", "Task" `Text.isPrefixOf` t, any isOpenType (drop 1 (atoms t)) = problem "missing-controller" "‘task’ needs two things: how it starts, and what it does." "If nothing is to be done first, write: task () f."
  | c == "Command", "Task" `Text.isPrefixOf` t, "replicate " `Text.isInfixOf` here = problem "controller-needed" "This is a list of tasks, and a list is not one after the other." "To do a task several times, write replicateM_ instead of replicate."
  | c == "Command", "Task" `Text.isPrefixOf` t = blaming outputs (problem "controller-needed" (owner <> " is a task, but here a function for the robot is needed.") "Simulate the task alone, or put it into another task with do.")
  | c == "Command", "IO" `Text.isPrefixOf` t = problem "not-a-command" "This is for the computer, not for the robot." "To show a text, give Say; in a task, write say."
  | c `elem` ["Command", "Controller"], shown == "String" = blaming outputs (problem "not-a-command" (who "gives" <> "a ‘String’, which is not a command.") "To show a text, write Say in front of it.")
  | c `elem` ["Command", "Controller", "Runnable"] = blaming outputs (problem "not-a-command" (who "gives" <> a t <> ", which is not a command.") commandHint)
  | c == "Default" = problem "not-memorable" ("A " <> quoted t <> " cannot be remembered.") "Memory holds numbers, texts, lists, and types of your own."
  | c == "Value" = problem "not-memorable" ("A " <> quoted t <> " cannot be kept or sent.") "Events and memories hold numbers, texts, lists, and types of your own."
  | Just (k, sum') <- looseCalculation here, c `elem` ["Num", "Fractional"], isFunction t || t == k = problem "operator" "A calculation among other values needs brackets." ("Write it as (" <> sum' <> ").")
  | isFunction t, user == "-", "Num" == c = problem "negative-number" "Here minus takes one thing from another." "A negative number needs brackets: (-0.5)."
  | c == "Show", isFunction t = problem "function-as-value" "A function cannot be shown as a text." "Give it its values first."
  | isFunction t = problem "function-as-value" ("Here a value is needed, but this is " <> a t <> ".") "Give the function its values, or check the brackets."
  | c == "Show" = problem "missing-deriving" ("It is not known how to show " <> a t <> " as a text.") "Write at the end of its declaration: deriving Show."
  | c == "Eq" = problem "missing-deriving" ("It is not known when two values of " <> quoted t <> " are equal.") "Write at the end of its declaration: deriving Eq."
  | c == "Ord" = problem "missing-deriving" ("It is not known which value of " <> quoted t <> " is the larger.") "Write at the end of its declaration: deriving (Eq, Ord)."
  | c `elem` ["Num", "Fractional", "Floating", "Integral", "RealFrac"], t == "String", user == "+" = problem "type-mismatch" "Texts cannot be added with +." "To put one behind the other, write ++."
  | c `elem` ["Fractional", "Floating", "RealFrac"], t `elem` ["Int", "Integer"] = problem "type-mismatch" ("A whole number (" <> quoted t <> ") cannot hold what this gives.") "Turn it into a Double with fromIntegral, or divide with div."
  | c `elem` ["Integral", "Bits"] = problem "type-mismatch" ("A whole number is needed here, but this is " <> a t <> ".") "Turn it into one with round or truncate."
  | c `elem` ["Num", "Fractional"], "literal" `Text.isInfixOf` whole = problem "type-mismatch" ("A number stands where " <> a t <> " is needed.") (numberHint t)
  | c `elem` ["Num", "Fractional", "Floating"] = problem "calculation" ("With " <> a t <> " one cannot calculate.") (if t `elem` ["Velocity", "Position", "Pose"] then "Take its numbers out with a pattern, as in (Velocity v w), and put them together again." else if "Memory" `Text.isPrefixOf` t then "Take out what it holds with a pattern: (Memory n)." else if Text.null user then "Check which value was meant." else quoted user <> " works on numbers only.")
  | c `elem` ["Monad", "Applicative", "Functor", "MonadFail", "Foldable", "Traversable"] = problem "type-mismatch" (quoted t <> " cannot be used with " <> quoted user <> ".") "Check which value was meant."
  | otherwise = problem "type-mismatch" (a' t <> " cannot be used with " <> quoted user <> ".") (if ("class " <> c) `Text.isInfixOf` text outline then "Say what it does for it: declare it for " <> quoted t <> " as well." else "Check which value was meant.")
  where
    here = maybe "" (\s -> Text.concat (take 1 (drop (line (start s) - 1) (Text.lines (text outline))))) (region raw)
    isOpenType = maybe False (isLower . fst) . Text.uncons
    whole = flat (Text.unwords (important raw))
    shown = if t == "Char" then "String" else t
    a' x = "A " <> quoted x
    -- The function whose type has it, and how its type is written there.
    culprit which = listToMaybe [(f, as) | (f, full) <- zip (connectedTo outline) (spelledOut outline), (as, x) <- zip (which f) (map simple (which full)), x `elem` [t, shown]]
    blamed = culprit (if c == "Sensor" then inputs else outputs)
    owner = maybe "This" (quoted . called . fst) blamed
    who verb = owner <> " " <> verb <> " "
    blaming which p = case culprit which of
      Just (f, as) -> p {function = Just (called f), place = typePlace outline (called f) as <|> place p}
      Nothing -> p
    sensorHint
      | isFunction t = "A function can take events, states and memories, but no functions."
      | "Task" `Text.isPrefixOf` t = "Tasks are started with do or with call."
      | "[" `Text.isPrefixOf` t || t == "String" = "To remember one between firings, take Memory " <> bracketIfNeeded t <> "."
      | t `elem` ["Int", "Integer", "Double", "Float", "Bool", "Char"] = "To remember one between firings, take Memory " <> t <> "."
      | "Led" `Text.isPrefixOf` t || t `elem` ["Sound", "Say"] = "It can only be commanded."
      | otherwise = "Take something that happens or a Memory, or declare a type of your own."
    commandHint
      | isFunction t = "Give the inner function its values."
      | t `elem` ["Int", "Integer", "Double", "Float"] = "To drive, give a Velocity; to remember the number, give Memory " <> t <> "."
      | t == "Bool" = "To remember it for other functions, give Memory Bool."
      | t `elem` ["Seconds", "StdGen", "Clock", "Position", "Orientation", "Pose"] = "It can only be sensed."
      | otherwise = "Give a command such as Velocity, a Memory, or a type of your own."

bracketIfNeeded :: Type -> Type
bracketIfNeeded t = if length (atoms t) > 1 then "(" <> t <> ")" else t

-- | Where a type is written in the signature of a function.
typePlace :: Outline -> Text -> Type -> Maybe Span
typePlace outline name t = do
  s <- lookup name (signatures outline)
  l <- listToMaybe (drop (line (start s) - 1) (Text.splitOn "\n" (text outline)))
  let signature = if line (start s) == line (end s) then Text.take (column (end s) - 1) l else l
      (before, rest) = Text.breakOn "::" signature
      (more, found) = Text.breakOn t rest
      from = Text.length before + Text.length more + 1
  if Text.null found then Nothing else Just (Span (start s) {column = from} (start s) {column = from + Text.length t})

-- * One type is needed, another is there

explainMismatch :: Outline -> Raw -> Say -> Type -> Type -> Problem
explainMismatch outline raw problem needed given
  | "NotInATask" `elem` [needed, given] = doneOutside
  | Just u <- user, u `elem` ["task", "taskWith"] = problem "done-type" ("The task ends with " <> a needed <> ", but its Done carries " <> a given <> ".") (if needed == "String" then "Make both the same, or turn what it ends with into a text with show." else "Make both the same type.")
  | "IO" == firstAtom needed, "IO action ‘main’" `Text.isInfixOf` whole = problem "main-type" "‘main’ must say what to do with the robot." ("Write: main = simulate " <> mainBody <> ".")
  | "Occurs check" `Text.isInfixOf` said || isVariable needed && needed `elem` Text.words given || isVariable given && given `elem` Text.words needed = problem "infinite-type" "This would have to contain itself." "Check the brackets, and whether a function is given to itself by accident."
  | Just p <- slip outline raw problem needed given = p
  | Just (f, taken, has) <- tooMany = tooManyArguments f taken has
  | Just f <- equationsTooLong = problem "argument-count" (quoted f <> " takes more than its type says.") ("Add to the type what it takes: " <> f <> " :: Bumper -> " <> lastOf needed <> ".")
  | "m" == firstAtom given, Just w <- firstOf' source, w `elem` ["return", "pure"] = problem "type-mismatch" ("A function gives its value without ‘" <> w <> "’.") ("Remove ‘" <> w <> "’.")
  | "too few arguments" `Text.isInfixOf` whole, Just f <- appliedTooLittle = missingArgument f
  | needed == "Maybe " <> bracketIfNeeded given = problem "missing-just" ("This always gives " <> a given <> ", but the type says that it may be missing.") ("Write Just in front of it" <> example "Just" <> ".")
  | given == "Maybe " <> bracketIfNeeded needed || "Maybe" == firstAtom given && "Maybe" /= firstAtom needed = problem "unexpected-maybe" ("This may be nothing, but " <> a needed <> " is needed.") ("Write the type as Maybe " <> bracketIfNeeded needed <> ", or give a value in every case.")
  | "Memory" == firstAtom needed, "Memory" /= firstAtom given, not (isFunction given) = problem "missing-memory" ("This is " <> a given <> ", but " <> a needed <> " is needed.") ("Write Memory in front of the value" <> example "Memory" <> ".")
  | "Memory" == firstAtom given, "Memory" /= firstAtom needed, firstOf' source == Just "Memory" = problem "memory-as-value" ("This is a whole Memory, but the type says " <> quoted needed <> ".") ("Write the type as " <> given <> ".")
  | "Memory" == firstAtom given, "Memory" /= firstAtom needed = problem "memory-as-value" ("This is a whole Memory, but the " <> quoted needed <> " in it is needed.") "Take it out with a pattern: (Memory x) instead of x."
  | "Memory" == firstAtom needed, "Memory" == firstAtom given = problem "memory-types" ("This memory holds " <> a (inner given) <> ", but one with " <> a (inner needed) <> " is needed.") "Each memory has one type: use the same everywhere."
  | "Task" == firstAtom needed, "Task" == firstAtom given = problem "task-result" ("This task ends with " <> a (stripBrackets (inner given)) <> ", but one that ends with " <> a (stripBrackets (inner needed)) <> " is needed.") (if stripBrackets (inner needed) == "()" then "If its result is not needed, write" <> maybe " void in front of it" (\s -> " void (" <> s <> ")") source <> "." else "The last line of a task gives its result.")
  | "Task" == firstAtom needed = problem "task-needed" ("A task is needed here, but this is " <> a given <> ".") ("Turn a command into a task with once" <> example "once" <> ".")
  | "Task" == firstAtom given, "IO" == firstAtom needed = problem "controller-needed" "This is a task, but ‘main’ only says what to simulate." "Put all the steps behind it: main = simulate (do …)."
  | "Task" == firstAtom given = problem "controller-needed" ("This is a task, but " <> a needed <> " is needed here.") "Start a task with simulate, or in another task with do."
  | needed == "Bool", behindNot = problem "type-mismatch" "‘not’ takes only what stands right behind it." "Put brackets around the comparison: not (a > b)."
  | needed == "Bool", "if" `Text.isInfixOf` whole = problem "type-mismatch" ("The condition of an ‘if’ is true or false, but this is " <> a given <> ".") "Compare it with something, for example with ==."
  | isNumber needed, isNumber given, needed /= given = problem "type-mismatch" (theseAre <> " but " <> a needed <> " is needed.") (convert needed given)
  | isNumber needed, given == "String" = problem "type-mismatch" ("This is a text, but a number (" <> quoted needed <> ") is needed.") "Numbers stand without quotation marks."
  | needed == "String", isNumber given || given `elem` ["Bool", "Orientation"] = problem "type-mismatch" ("This is " <> a given <> ", but a text is needed.") ("Turn it into a text with show" <> example "show" <> ".")
  | needed == "[" <> given <> "]" = problem "type-mismatch" ("This is one " <> quoted given <> ", but a list of them is needed.") "Put it in square brackets."
  | given == "[" <> needed <> "]" = problem "type-mismatch" ("This is a list, but one " <> quoted needed <> " is needed.") "Take one element of it."
  | isFunction given, not (isFunction needed), lastOf given == needed = problem "missing-argument" ("Something is missing here: this still needs " <> a (firstOf given) <> ".") "Add the missing value."
  | "Either" : l : r : _ <- atoms needed, Just side <- lookup given [(l, "Left"), (r, "Right")] = problem "missing-side" ("This is " <> a given <> ", but " <> a needed <> " is needed here.") ("Say which of the two it is" <> example side <> ".")
  | given == "Say", needed == "String" || "[" `Text.isPrefixOf` needed = problem "operator" "Only the first text belongs to this ‘Say’." "Put brackets around all of the text: Say (\"hits: \" ++ show n)."
  | isFunction given, isFunction needed, maybe False (\s -> "[" `Text.isInfixOf` Text.take (column (start s) - 1) (lineAt s)) (region raw) = problem "type-mismatch" "The parts of a list have one type, and these differ." "Put functions of different types into round brackets: (f, g)."
  | Just c <- wrapperOf given needed = problem "type-mismatch" ("This is " <> a given <> ", but " <> a needed <> " is needed here.") ("Write " <> c <> " in front of it" <> example c <> ".")
  | "(" `Text.isPrefixOf` given, "StdGen)" `Text.isSuffixOf` given = problem "type-mismatch" ("This is a pair with a new generator, but " <> a needed <> " is needed here.") ("Take the first of the two" <> example "fst" <> ".")
  | isFunction needed, not (isFunction given), not (isVariable given) = problem "type-mismatch" ("The type says that this takes " <> a (firstOf needed) <> ", but nothing is taken here.") "Name what it takes on the left of the equals sign, or change the type."
  | "rigid type variable" `Text.isInfixOf` whole = problem "too-general" ("The type says that this works for any ‘" <> (if isVariable needed then needed else given) <> "’, but it does not.") "Write the type that is meant instead of the small letter."
  | isFunction given, not (isFunction needed) = problem "type-mismatch" ("This is " <> a given <> ", but " <> a needed <> " is needed here.") "Give the function its values, or check the brackets."
  | otherwise = problem "type-mismatch" ("This is " <> a given <> ", but " <> a needed <> " is needed here.") (mixedHint needed given)
  where
    said = scrub (flat (Text.unwords (important raw)))
    whole = scrub (flat (Text.unwords (important raw ++ context raw ++ supplementary raw)))
    user = listToMaybe . quotes =<< after "arising from a use of" said
    firstAtom = fromMaybe "" . listToMaybe . atoms
    inner t = Text.unwords (drop 1 (atoms t))
    source = region raw >>= snippet (text outline)
    example f = maybe "" (\s -> ": " <> f <> " " <> (if Text.any (== ' ') s && not (Text.isPrefixOf "(" s) then "(" <> s <> ")" else s)) source
    -- The word that what is wrong begins with.
    firstOf' = (>>= listToMaybe . Text.words)
    equationsTooLong = do
      rest <- after "The equation(s) for ‘" whole
      if any (`Text.isInfixOf` rest) ["has none", "has only"] then Just (Text.takeWhile (/= '’') rest) else Nothing
    lineAt s = fromMaybe "" (listToMaybe (drop (line (start s) - 1) (Text.lines (text outline))))
    behindNot = maybe False (\s -> "not" `elem` take 1 (reverse (Text.words (Text.take (column (start s) - 1) (lineAt s))))) (region raw)
    firstOf = fromMaybe "" . listToMaybe . splitArrows
    lastOf = fromMaybe "" . listToMaybe . reverse . splitArrows
    isVariable t = maybe False (isLower . fst) (Text.uncons t) && not (Text.any (== ' ') t)
    theseAre = "This is " <> a given <> (if given `elem` ["Int", "Integer"] then ", a whole number," else ",")

    doneOutside =
      let blamed = find (any ("Done" `Text.isPrefixOf`) . outputs) (connectedTo outline)
          p = problem "done-outside-task" (maybe "This" (quoted . called) blamed <> " gives Done, but it is not part of a task.") "Remove Done, or put the function into a task: task () f."
       in case blamed of
            Just f -> p {function = Just (called f), place = typePlace outline (called f) "Done" <|> place p}
            Nothing -> p

    mainBody = case source of
      _ | Just l <- mainLine, not ("simulate" `Text.isInfixOf` l), Text.length l < 40 -> asArgument l
      _ -> "f"
    asArgument l
      | "do" `elem` take 1 (Text.words l) = "$ " <> l
      | Text.any isSpace l && not ("(" `Text.isPrefixOf` l) && not ("[" `Text.isPrefixOf` l) = "(" <> l <> ")"
      | otherwise = l
    mainLine = fmap (Text.strip . Text.drop 1) (listToMaybe [snd (Text.breakOn "=" l) | l <- Text.lines (text outline), "main" `elem` take 1 (Text.words l)])

    appliedTooLittle = listToMaybe . quotes =<< after "Probable cause:" whole
    missingArgument f
      | f `elem` ["return", "pure"] = problem "missing-argument" (quoted f <> " needs the value that it gives.") ("If there is none, write: " <> f <> " ().")
      | f == "call" = problem "missing-argument" "‘call’ needs two things: a task, and what to do with it." "Write callOptions behind the task."
      | not (null missing), any isVariable missing = problem "missing-argument" (quoted f <> " needs " <> (if length missing == 1 then "another value." else number (length missing) <> " more values.")) "Add what is missing."
      | not (null missing) = problem "missing-argument" (quoted f <> " needs " <> (if length missing == 1 then "another value: " else number (length missing) <> " more values: ") <> Text.intercalate ", then " (map a missing) <> ".") "Add what is missing."
      | otherwise = problem "missing-argument" (quoted f <> " needs more values than it is given.") "Add what is missing."
      where
        parts = splitArrows given
        missing = take (length parts - length (splitArrows needed)) parts

    -- The function, how many values it is given, how many it takes.
    tooMany = do
      rest <- after "The function ‘" whole <|> after "The data constructor ‘" whole <|> after "The constructor ‘" whole
      taken <- between "is applied to " " value argument" rest
      Just (Text.takeWhile (/= '’') rest, taken, fromMaybe "none" (between "has only" "|" (Text.replace " In " "|" rest)))
    tooManyArguments f taken has
      | overLines = problem "indentation" "The next line seems to go on with this one." "Lines of one block begin in the same column."
      | f == "simulate", Just s <- source, t : v : _ <- drop 1 (Text.words s), Text.all (`elem` ("0123456789.\"" :: String)) (Text.take 1 v) = problem "too-many-arguments" "‘simulate’ takes one thing only." ("Put brackets around what belongs together: simulate (" <> Text.unwords [t, v] <> ").")
      | f == "simulate" = problem "too-many-arguments" "‘simulate’ takes one thing only." "Put several functions into brackets with commas: simulate (f, g)."
      | Just so <- lookup f [("once", "one thing only"), ("task", "two things"), ("taskWith", "two things"), ("call", "two things")] = problem "too-many-arguments" (quoted f <> " takes " <> so <> ".") "Put brackets around what belongs together, for example: once (Velocity 0.5 0)."
      | f == "repeat" = problem "too-many-arguments" "‘repeat’ goes on for ever, and takes no number." "To do a task several times, write: replicateM_ 4 (say \"hello\")."
      | f == "randomR" = problem "too-many-arguments" "‘randomR’ takes both ends as one pair, and a generator." "Write: fst (randomR (0, 1) gen)."
      | f == "show", Just s <- source, (n, quote) <- Text.breakOn " \"" (Text.drop 5 s), not (Text.null quote) = problem "operator" "Only the first value belongs to this ‘show’." ("Between two texts stands ++: show " <> n <> " ++" <> quote <> ".")
      | "none" == has, Just s <- source, "simulate" `elem` Text.words (maybe "" lineAt (region raw)), not (Text.any (`elem` ("()" :: String)) s) = problem "too-many-arguments" (quoted f <> " takes no values, but is given " <> taken <> ".") ("If these are several functions, put commas between them: (" <> Text.intercalate ", " (Text.words s) <> ").")
      | "none" == has || "has none" `Text.isInfixOf` whole = problem "too-many-arguments" (quoted f <> " takes no values, but is given " <> taken <> ".") "Remove what is too much, or check the brackets."
      | otherwise = problem "too-many-arguments" (quoted f <> " is given " <> taken <> " values, which is too many.") "Remove what is too much, or put brackets around what belongs together."
    overLines = maybe False (\s -> line (start s) < line (end s)) (region raw) && "do" `Text.isInfixOf` whole
