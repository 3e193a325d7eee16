{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TypeErrors
-- Description : Explanations of type mismatches and missing instances.
--
-- Covers two families of messages: an expected type that differs from the actual one, and a type without a needed class (sensing, being a
-- command, showing, adding). Each has special cases for robot programs and a general sentence.
module Rosy.Worker.Explanation.TypeErrors
  ( explainTypes,
    typePlace,
  )
where

import Control.Applicative ((<|>))
import Data.Char (isAlphaNum, isDigit, isLower, isSpace, isUpper)
import Data.List (find, nub, tails)
import Data.Maybe (fromMaybe, isJust, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.MismatchCauses
import Rosy.Worker.Explanation.MismatchRepairs
import Rosy.Worker.Explanation.RobotTypes (commandOnly, commandTypes, sensedOnly, typesOfValues)
import Rosy.Worker.Explanation.RobotVocabulary
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

explainTypes :: ProgramOutline -> CompilerMessage -> Maybe Problem
explainTypes outline raw =
  (stated ambiguousIn ambiguous >>= \(v, c, user) -> Just (explainAmbiguous outline problem v c user))
    <|> (if "Overlapping instances for Runnable" `Text.isPrefixOf` said then Just (unclear outline problem) else Nothing)
    <|> (stated instanceIn noInstance >>= \(c, t, user) -> Just (explainInstance outline raw problem c t user))
    <|> (stated mismatchIn mismatch >>= \(needed, given) -> Just (explainMismatch outline raw problem needed given))
    <|> (if "rigid type variable" `Text.isInfixOf` said then Just (problem "too-general" (tr "The type promises more than the definition keeps.") (tr "Write the type that it really has.")) else Nothing)
  where
    said = withoutGeneratedNames (oneLine (Text.unwords (important raw)))
    problem k m h = Problem (messageSeverity raw) k (messageSpan raw) Nothing m h "" []
    -- What GHC states as data, or else what its prose says.
    stated fromData fromProse = maybe (fromProse said) (fromData said) (finding raw)

type Say = Text -> Sentence -> Sentence -> Problem

-- * What GHC states as data

mismatchIn :: Text -> Finding -> Maybe (Type, Type)
mismatchIn _ found = case found of
  TypesDiffer needed given -> Just (simplifyType needed, simplifyType given)
  _ -> Nothing

instanceIn :: Text -> Finding -> Maybe (Text, Type, Text)
instanceIn said found = case found of
  InstanceMissing constraint user -> Just (classOf constraint, simplifyType (stripBrackets (Text.strip (Text.drop 1 (snd (Text.breakOn " " (oneLine constraint)))))), maybe (userIn said) withoutGeneratedNames user)
  _ -> Nothing

ambiguousIn :: Text -> Finding -> Maybe (Text, Text, Text)
ambiguousIn said found = case found of
  VariableAmbiguous v constraint user -> Just (v, classOf constraint, maybe (userIn said) withoutGeneratedNames user)
  _ -> Nothing

classOf :: Text -> Text
classOf = Text.takeWhile (/= ' ') . oneLine

-- * Analysis of messages

-- | Expected and actual type.
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
    needed : given : _ <- quotedParts rest =
    Just (simplifyType needed, simplifyType given)
  | otherwise = Nothing
  where
    colon t = Text.strip (fromMaybe t (Text.stripPrefix ":" (Text.strip t)))
    upToNote t = foldr (\mark x -> fst (Text.breakOn mark x)) t ["‘’", " arising from", " Type synonyms", " The type variable", " because type"]

-- | Class, type, and the expression that requires it.
noInstance :: Text -> Maybe (Text, Type, Text)
noInstance said = do
  rest <- after "No instance for (" said
  let inside = bracketed rest
      (c, t) = Text.breakOn " " inside
  Just (c, simplifyType (stripBrackets (Text.strip t)), userIn said)

-- | The expression that a constraint arises from.
userIn :: Text -> Text
userIn said = maybe "" (\x -> fromMaybe (Text.takeWhile (/= ' ') x) (listToMaybe (quotedParts x))) (after "arising from" said)

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

-- | Type variable, class, and the expression that requires it.
ambiguous :: Text -> Maybe (Text, Text, Text)
ambiguous said = do
  rest <- after "Ambiguous type variable" said
  let names = quotedParts rest
      v = fromMaybe "" (listToMaybe names)
      c = maybe "" (Text.takeWhile (/= ' ')) (after "the constraint ‘(" rest)
      user = fromMaybe "" (listToMaybe (drop 1 names))
  Just (v, c, user)

-- * Ambiguous types

explainAmbiguous :: ProgramOutline -> Say -> Text -> Text -> Text -> Problem
explainAmbiguous outline problem v c user
  | letter == "feed" = feedbackOfWhat problem
  | Text.length letter > 2 = blamedFor letter (problem "lower-case-type" (trWith "‘{type}’ stands for any type, because it begins with a small letter." ["type" =: letter]) (trWith "Write the type with a capital letter: {capital}" ["capital" =: capital letter]))
  | c `elem` ["Sensor", "Command", "Controller", "Runnable", "Ends", "Default", "Value"] = unclear outline problem
  | user `elem` ["read", "fromIntegral", "realToFrac"] = problem "ambiguous-type" (trWith "It is not clear which type ‘{function}’ gives here." ["function" =: user]) (tr "Say it, for example: (read \"1\" :: Double)")
  | otherwise = problem "ambiguous-type" (tr "It is not clear which type this value has.") (tr "Say it after the value, for example: (1 :: Double)")
  where
    letter = Text.dropWhileEnd (`elem` ("0123456789" :: String)) v
    capital t = Text.toUpper (Text.take 1 t) <> Text.drop 1 t
    blamedFor t p = case [(called f, s) | f <- connectedTo outline, Just s <- [typePlace outline (called f) t]] of
      (f, s) : _ -> p {function = Just f, place = Just s}
      [] -> p

-- | The type of feedback is ambiguous.
feedbackOfWhat :: Say -> Problem
feedbackOfWhat problem = problem "ambiguous-type" (tr "It is not clear of which type this feedback is.") (tr "Say it where it is taken, for example: \\x -> Say (show (x :: Double))")

-- | A function whose inputs or outputs are ambiguous.
unclear :: ProgramOutline -> Say -> Problem
unclear outline problem = case find (any isOpen . (\f -> inputs f ++ outputs f)) (connectedTo outline) of
  Just f ->
    let p = case (lookup (called f) (signatures outline), atVelocity =<< lookup (called f) (typesOfNames outline)) of
          (Just _, Just t) -> problem "ambiguous-type" (trWith "‘{function}’ works at many types, and it is not said at which." ["function" =: called f]) (trWith "Say it where it is used: ({function} :: {type})" ["function" =: called f, "type" =: t])
          (Just _, Nothing) -> problem "ambiguous-type" (trWith "‘{function}’ works at many types, and it is not said at which." ["function" =: called f]) (tr "Write the types that are meant in place of the small letters of its type.")
          (Nothing, t) -> problem "ambiguous-type" (trWith "‘{function}’ does not say what it senses or gives." ["function" =: called f]) (trWith "Write its type above it, for example: {code}" ["code" =: called f <> " :: " <> fromMaybe "Bumper -> Maybe Sound" t])
     in p {function = Just (called f), place = (lookup (called f) (signatures outline) <|> lookup (called f) (bindings outline)) <|> place p}
  Nothing | Just w <- looseForever -> problem "too-many-arguments" (tr "‘forever’ takes only what comes right after it.") (trWith "Put brackets around the task: forever ({task})" ["task" =: w])
  Nothing -> problem "ambiguous-type" (tr "This does not say what it senses or gives.") (tr "Write its type above it, for example: f :: Bumper -> Maybe Sound")
  where
    -- forever say "x"
    looseForever = listToMaybe [rest | l <- Text.lines (text outline), Just more <- [after "forever " l], let rest = Text.strip (Text.takeWhile (`notElem` (")" :: String)) more), w : _ : _ <- [Text.words rest], maybe False (isLower . fst) (Text.uncons w), w /= "do", not ("$" `Text.isInfixOf` rest)]
    isOpen = any (maybe False (isLower . fst) . Text.uncons) . Text.words . Text.map (\x -> if isAlphaNum x || x `elem` ("_'" :: String) then x else ' ')

-- | A type with 'Velocity' for its variables; nothing if they have constraints.
atVelocity :: Type -> Maybe Type
atVelocity t
  | "=>" `Text.isInfixOf` t = Nothing
  | otherwise = Just (Text.concat (map atom (Text.groupBy (\x y -> isName x == isName y) t)))
  where
    isName x = isAlphaNum x || x `elem` ("_'" :: String)
    atom w = if maybe False (isLower . fst) (Text.uncons w) then "Velocity" else w

-- * Missing instances

explainInstance :: ProgramOutline -> CompilerMessage -> Say -> Text -> Type -> Text -> Problem
explainInstance outline raw problem c t user
  | c == "Typeable", t == "feed" = feedbackOfWhat problem
  | c `elem` ["Typeable", "Value", "Default"], isOpenType t, user == "simulate" = unclear outline problem
  | c `elem` ["Sensor", "Command", "Controller", "Runnable"], parts <- tupleParts t, length parts > largestTuple = largeTuple outline raw problem (length parts)
  | c == "Typeable", isOpenType t, "Done" `elem` Text.words (Text.map (\x -> if isAlphaNum x then x else ' ') (text outline)) = problem "ambiguous-type" (tr "It is not clear with what this task ends.") (endHint outline (messageSpan raw))
  | c == "Typeable", isOpenType t = problem "ambiguous-type" (tr "This task has no end: none of its functions gives Done.") (tr "Give Done () when it is over; if it goes on for ever, say so: (task start go :: Task ())")
  | c == "Sensor", Just (f, _) <- culprit inputs, any ("Task" `Text.isPrefixOf`) (outputs f) = problem "missing-argument" (trWith "‘{function}’ needs a value before it is a task." ["function" =: called f]) (trWith "Give it one: simulate ({function} …)" ["function" =: called f])
  | c == "Enum", t == "String" = problem "calculation" (tr "Here numbers are counted, but texts are needed.") (tr "Turn each number into a text with show: (say . show)")
  | c == "Sensor", Just (f, _) <- culprit inputs, Just (k, s) <- partialConstructor outline (called f) = (problem "missing-argument" (trWith "‘{function}’ needs another value: {then types}." ["function" =: k, "types" =* [t]]) (addMissing k)) {function = Just (called f), place = Just s}
  | c == "Sensor", isNumber t, Nothing <- culprit inputs, k : _ <- Text.words (Text.dropWhile (`elem` ("($ " :: String)) (fromMaybe "" (after "simulate" here))), isUpper (Text.head k) = problem "missing-argument" (trWith "‘{function}’ needs another value: {then types}." ["function" =: k, "types" =* [t]]) (addMissing k)
  | c == "Sensor" = blaming inputs (problem "not-a-sensor" (maybe (trWith "This takes {a type}, which the robot cannot sense." ["type" =: t]) (\f -> trWith "‘{function}’ takes {a type}, which the robot cannot sense." ["function" =: f, "type" =: t]) owner) sensorHint)
  | c == "Command", "Task" `Text.isPrefixOf` t, any isOpenType (drop 1 (typeAtoms t)) = problem "missing-controller" (tr "‘task’ needs two things: how it starts, and what it does.") (tr "If nothing is to be done first, write: task () f")
  | c == "Command", "Task" `Text.isPrefixOf` t = blaming outputs (problem "controller-needed" (maybe (tr "This is a task, but here a function for the robot is needed.") (\f -> trWith "‘{function}’ is a task, but here a function for the robot is needed." ["function" =: f]) owner) callHint)
  | c == "Command", "IO" `Text.isPrefixOf` t = problem "not-a-command" (tr "This is for the computer, not for the robot.") (tr "To show a text, give Say; in a task, write say.")
  | c `elem` ["Command", "Controller"], shown == "String" = blaming outputs (problem "not-a-command" (notACommand "String") (tr "To show a text, write Say in front of it."))
  | c `elem` ["Command", "Controller", "Runnable"] = blaming outputs (problem "not-a-command" (notACommand t) commandHint)
  | c == "Default", isJust (lookup (fromMaybe t (listToMaybe (typeAtoms t))) (bindings outline)) = problem "not-memorable" (trWith "A ‘{type}’ has no value that a memory could start with." ["type" =: t]) (trWith "Remember a list of them, which starts empty: Memory [{type}]" ["type" =: t])
  | c == "Default" = problem "not-memorable" (trWith "A ‘{type}’ cannot be remembered." ["type" =: t]) (tr "Memory holds numbers, texts, lists, and types of your own.")
  | c == "Value" = problem "not-memorable" (trWith "A ‘{type}’ cannot be kept or sent." ["type" =: t]) (tr "Events and memories hold numbers, texts, lists, and types of your own.")
  | Just (k, sum') <- unbracketedCalculation here, c `elem` ["Num", "Fractional"], isFunction t || t == k = problem "operator" (tr "A calculation among other values needs brackets.") (trWith "Write it as ({code})" ["code" =: sum'])
  | isFunction t, user == "-", "Num" == c = problem "negative-number" (tr "Here minus takes one thing from another.") (trWith "A negative number needs brackets: (-{number})" ["number" =: subtrahend])
  | c == "Show", isFunction t = problem "function-as-value" (tr "A function cannot be shown as a text.") (tr "Give it its values first.")
  | isFunction t = problem "function-as-value" (trWith "Here a value is needed, but this is {a type}." ["type" =: t]) (tr "Give the function its values, or check the brackets.")
  | c == "Show" = problem "missing-deriving" (trWith "It is not known how to show {a type} as a text." ["type" =: t]) (tr "Write at the end of its declaration: deriving Show")
  | c == "Eq" = problem "missing-deriving" (trWith "It is not known when two values of ‘{type}’ are equal." ["type" =: t]) (tr "Write at the end of its declaration: deriving Eq")
  | c == "Ord" = problem "missing-deriving" (trWith "It is not known which value of ‘{type}’ is the larger." ["type" =: t]) (tr "Write at the end of its declaration: deriving (Eq, Ord)")
  | c `elem` ["Num", "Fractional", "Floating", "Integral", "RealFrac"], t == "String", user == "+" = problem "type-mismatch" (tr "Texts cannot be added with +.") (tr "To join them, write ++.")
  | c `elem` ["Fractional", "Floating", "RealFrac"], t `elem` ["Int", "Integer"] = problem "type-mismatch" (trWith "A whole number (‘{type}’) cannot hold what this gives." ["type" =: t]) (tr "Turn it into a Double with fromIntegral, or divide with div.")
  | c `elem` ["Integral", "Bits"] = problem "type-mismatch" (trWith "A whole number is needed here, but this is {a type}." ["type" =: t]) (tr "Turn it into one with round or truncate.")
  | c `elem` ["Num", "Fractional"], "literal" `Text.isInfixOf` whole, Just m <- rememberedNumber = problem "type-mismatch" (trWith "There is a number, but the type says ‘{type}’." ["type" =: t]) (if t == "Bool" then trWith "Write the type as {given}, or True or False in place of the number." ["given" =: m] else trWith "Write the type as {given}, or {a type} in place of the number." ["given" =: m, "type" =: t])
  | c `elem` ["Num", "Fractional"], "literal" `Text.isInfixOf` whole = problem "type-mismatch" (trWith "There is a number where {a type} is needed." ["type" =: t]) (numberMismatchHint t)
  | c `elem` ["Num", "Fractional", "Floating"] = problem "calculation" (trWith "With {a type} one cannot calculate." ["type" =: t]) calculationHint
  | c `elem` ["Monad", "Applicative", "Functor", "MonadFail", "Foldable", "Traversable"] = problem "type-mismatch" (trWith "‘{type}’ cannot be used with ‘{function}’." ["type" =: t, "function" =: user]) (tr "Check which value was meant.")
  | otherwise = problem "type-mismatch" (trWith "A ‘{type}’ cannot be used with ‘{function}’." ["type" =: t, "function" =: user]) (if ("class " <> c) `Text.isInfixOf` text outline then trWith "Say what it does for it: declare it for ‘{type}’ as well." ["type" =: t] else tr "Check which value was meant.")
  where
    here = maybe "" (\s -> Text.concat (take 1 (drop (line (start s) - 1) (Text.lines (text outline))))) (messageSpan raw)
    isOpenType = maybe False (isLower . fst) . Text.uncons
    -- What stands behind the minus sign.
    subtrahend = case filter (not . Text.null) [Text.takeWhile (\x -> isAlphaNum x || x `elem` ("._'" :: String)) (Text.stripStart (Text.drop 2 behind)) | (_, behind) <- Text.breakOnAll " -" here] of
      n : _ -> n
      [] -> "1"
    whole = oneLine (Text.unwords (important raw))
    shown = if t == "Char" then "String" else t
    -- Behind Memory, in a function whose type has memories of this type only: the type that the number has.
    rememberedNumber = do
      s <- messageSpan raw
      f <- enclosing outline s
      signature <- lookup f (signatures outline)
      let memories = [w | m : w : _ <- tails (map word (tokenize (textAt (text outline) signature))), m == "Memory"]
          behindMemory = take 1 (reverse (Text.words (Text.take (column (start s) - 1) here))) `elem` [["Memory"], ["(Memory"]]
      if behindMemory && not (null memories) && all (== t) memories then Just (if "." `Text.isInfixOf` textAt (text outline) s then "Memory Double" else "Memory Int") else Nothing
    calculationHint
      | t `elem` ["Velocity", "Position", "Pose"] = tr "Take its numbers out with a pattern, as in (Velocity v w), and put them together again."
      | "Memory" `Text.isPrefixOf` t = tr "Take out what it holds with a pattern: (Memory n)"
      | Text.null user = tr "Check which value was meant."
      | otherwise = trWith "‘{function}’ works on numbers only." ["function" =: user]
    notACommand given = maybe (trWith "This gives {a type}, which is not a command." ["type" =: given]) (\f -> trWith "‘{function}’ gives {a type}, which is not a command." ["function" =: f, "type" =: given]) owner
    -- The function whose type has it, and how its type is written there.
    culprit which = listToMaybe (filter isHere candidates ++ candidates)
      where
        isHere (f, _) = messageSpan raw == lookup (called f) (bindings outline)
        candidates = [(f, as) | (f, full) <- zip (connectedTo outline) (spelledOut outline), (as, x) <- zip (which f) (map simplifyType (which full)), x `elem` [t, shown]]
    blamed = culprit (if c == "Sensor" then inputs else outputs)
    -- How the task of a function is started beside it, in the program's own words.
    callHint = case blamed of
      Just (f, _)
        | Just ts <- splitArrows <$> lookup (called f) (typesOfNames outline) ->
          trWith "Give a Call: {code}, and in it call ({task}) callOptions." ["code" =: called f <> " :: " <> Text.intercalate " -> " (init ts ++ ["Call"]), "task" =: fromMaybe "…" (bodyOf (called f))]
      _ -> tr "A function starts a task beside itself with call: call (…) callOptions"
    bodyOf f = do
      s <- lookup f (bindings outline)
      body <- after "=" (textAt (text outline) s)
      if "\n" `Text.isInfixOf` body || Text.length body > 40 then Nothing else Just (Text.strip body)
    owner = called . fst <$> blamed
    blaming which p = case culprit which of
      Just (f, as) -> p {function = Just (called f), place = typePlace outline (called f) as <|> place p}
      Nothing -> p
    sensorHint
      | isFunction t = tr "A function can take events, states and memories, but no functions."
      | "Task" `Text.isPrefixOf` t = tr "Tasks are started with do or with call."
      | "[" `Text.isPrefixOf` t || t == "String" = trWith "To remember one between firings, take Memory {type}" ["type" =: bracketIfNeeded t]
      | t `elem` ["Int", "Integer", "Double", "Float", "Bool", "Char"] = trWith "To remember one between firings, take Memory {type}" ["type" =: t]
      | t `elem` commandOnly = tr "It can only be commanded."
      | otherwise = tr "Take something that happens or a Memory, or declare a type of your own."
    commandHint
      | isFunction t = tr "Give the inner function its values."
      | t `elem` ["Int", "Integer", "Double", "Float"] = trWith "To drive, give a Velocity; to remember the number, give Memory {type}" ["type" =: t]
      | t == "Bool" = tr "To remember it for other functions, give Memory Bool."
      | t `elem` ["Seconds", "StdGen", "Clock"] || t `elem` sensedOnly = tr "It can only be sensed."
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
    written = maybe "" (textAt (text outline)) (messageSpan raw)
    -- From GHC 9.4 on the function alone is underlined, and the tuple stands behind it.
    behind = maybe "" (\s -> Text.drop (column (end s) - 1) (lineOf (text outline) (line (end s)))) (messageSpan raw)
    hint' = case tupleParts (Text.dropWhile (/= '(') (if Text.any (== '(') written then written else Text.stripEnd behind)) of
      names | length names == size, (firstOnes, rest) <- splitAt (largestTuple - 1) names -> trWith "Put the last ones into a tuple of their own: ({code})" ["code" =: Text.intercalate ", " (take 1 firstOnes ++ ["…", "(" <> Text.intercalate ", " rest <> ")"])]
      _ -> tr "Put some of them into a tuple of their own: (a, b, (c, d))"

bracketIfNeeded :: Type -> Type
bracketIfNeeded t = if length (typeAtoms t) > 1 then "(" <> t <> ")" else t

-- | Where a type is written in the signature of a function.
typePlace :: ProgramOutline -> Text -> Type -> Maybe Span
typePlace outline name t = do
  s <- lookup name (signatures outline)
  l <- listToMaybe (drop (line (start s) - 1) (Text.splitOn "\n" (text outline)))
  let signature = if line (start s) == line (end s) then Text.take (column (end s) - 1) l else l
      (before, rest) = Text.breakOn "::" signature
      (more, found) = Text.breakOn t rest
      from = Text.length before + Text.length more + 1
  if Text.null found then Nothing else Just (Span (start s) {column = from} (start s) {column = from + Text.length t})

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

-- * One type is needed, another is there

explainMismatch :: ProgramOutline -> CompilerMessage -> Say -> Type -> Type -> Problem
explainMismatch outline raw problem needed given
  | "NotInATask" `elem` [needed, given] = doneOutside
  | Just u <- user, u `elem` ["task", "taskWith"], Just p <- endUsedElsewhere outline raw problem needed given = p
  | Just u <- user, u `elem` ["task", "taskWith"] = problem "done-type" (trWith "The task ends with {a needed}, but its Done carries {a given}." ["needed" =: needed, "given" =: given]) (if needed == "String" then tr "Make both the same, or turn what it ends with into a text with show." else tr "Make both the same type.")
  | "IO" == firstAtom needed, "IO action ‘main’" `Text.isInfixOf` whole = problem "main-type" (tr "‘main’ must say what to do with the robot.") (trWith "Write: main = simulate {body}" ["body" =: mainBody])
  | "Occurs check" `Text.isInfixOf` said || isVariable needed && needed `elem` Text.words given || isVariable given && given `elem` Text.words needed = problem "infinite-type" (tr "This would have to contain itself.") (tr "Check the brackets, and whether a function is given to itself by accident.")
  | Just p <- mismatchCause outline raw problem needed given = p
  | Just (f, taken, has) <- tooMany = tooManyArguments f taken has
  | Just f <- equationsTooLong = problem "argument-count" (trWith "‘{function}’ takes more than its type says." ["function" =: f]) (takenHint outline f (messageSpan raw))
  | "m" == firstAtom given, Just w <- firstOf' source, w `elem` ["return", "pure"] = problem "type-mismatch" (trWith "A function gives its value without ‘{word}’." ["word" =: w]) (trWith "Remove ‘{word}’." ["word" =: w])
  | "too few arguments" `Text.isInfixOf` whole, Just f <- appliedTooLittle = missingArgument f
  | needed == "Maybe " <> bracketIfNeeded given = problem "missing-just" (trWith "This always gives {a given}, but the type says that it may be missing." ["given" =: given]) (maybe (tr "Write Just in front of it.") (\code -> trWith "Write Just in front of it: {code}" ["code" =: code]) (example "Just"))
  | given == "Maybe " <> bracketIfNeeded needed || "Maybe" == firstAtom given && "Maybe" /= firstAtom needed = problem "unexpected-maybe" (trWith "This may be nothing, but {a needed} is needed." ["needed" =: needed]) (trWith "Write the type as Maybe {type}, or give a value in every case." ["type" =: bracketIfNeeded needed])
  | "Memory" == firstAtom needed, "Memory" /= firstAtom given, not (isFunction given) = problem "missing-memory" (trWith "This is {a given}, but {a needed} is needed." ["given" =: given, "needed" =: needed]) (maybe (tr "Write Memory in front of the value.") (\code -> trWith "Write Memory in front of the value: {code}" ["code" =: code]) (example "Memory"))
  | "Memory" == firstAtom given, "Memory" /= firstAtom needed, firstOf' source == Just "Memory" = problem "memory-as-value" (trWith "This is a whole Memory, but the type says ‘{needed}’." ["needed" =: needed]) (trWith "Write the type as {given}" ["given" =: given])
  | "Memory" == firstAtom given,
    "Memory" /= firstAtom needed =
    problem
      "memory-as-value"
      (trWith "This is a whole Memory, but the ‘{needed}’ in it is needed." ["needed" =: needed])
      ( case source of
          Just x | Text.all isAlphaNum x -> trWith "Take it out with a pattern: (Memory {name}) instead of {name}" ["name" =: x]
          _ -> tr "Take it out with a pattern: (Memory x) instead of x."
      )
  | "Memory" == firstAtom needed, "Memory" == firstAtom given = problem "memory-types" (trWith "This memory holds {a inside}, but one with {a wanted} is needed." ["inside" =: inner given, "wanted" =: inner needed]) (tr "Each memory has one type: use the same everywhere.")
  | "Task" == firstAtom needed, "Task" == firstAtom given = problem "task-result" (trWith "This task ends with {a inside}, but one that ends with {a wanted} is needed." ["inside" =: stripBrackets (inner given), "wanted" =: stripBrackets (inner needed)]) (if stripBrackets (inner needed) == "()" then maybe (tr "If its result is not needed, write void in front of it.") (\s -> trWith "If its result is not needed, write void ({code})" ["code" =: s]) source else tr "The last line of a task gives its result.")
  | "Task" == firstAtom needed, Just own <- firstOf' source, own `elem` map fst readyTasks, isJust (lookup own (bindings outline)) = problem "task-needed" (trWith "Here ‘{name}’ is your own function, which hides the ready-made task." ["name" =: own]) (tr "Give your function another name.")
  | "Task" == firstAtom needed = problem "task-needed" (trWith "A task is needed here, but this is {a given}." ["given" =: given]) (maybe (tr "Turn a command into a task with once.") (\code -> trWith "Turn a command into a task with once: {code}" ["code" =: code]) (example "once"))
  | "Task" == firstAtom given, "IO" == firstAtom needed = problem "controller-needed" (tr "This is a task, but ‘main’ only says what to simulate.") (tr "Put all the steps after it: main = simulate (do …)")
  | "Task" == firstAtom given = problem "controller-needed" (trWith "This is a task, but {a needed} is needed here." ["needed" =: needed]) (tr "Start a task with simulate, or in another task with do.")
  | needed == "Bool", behindNot = problem "type-mismatch" (tr "‘not’ takes only what comes right after it.") (trWith "Put brackets around the comparison: {code}" ["code" =: ("not (" <> fromMaybe "a > b" comparison <> ")")])
  | needed == "Bool", "if" `Text.isInfixOf` whole = problem "type-mismatch" (trWith "The condition of an ‘if’ is true or false, but this is {a given}." ["given" =: given]) (maybe (tr "Compare it with something, for example with ==") (\code -> trWith "Compare it, for example: {code}" ["code" =: code]) (compared <$> source <*> listToMaybe [v | (v, t) <- typesOfValues, t == given || (t, given) == ("ButtonStatus", "BumperStatus")]))
  | Just code <- partCompared = problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (trWith "Compare it, for example: {code}" ["code" =: code])
  | needed == "Double", given == "Int", Just p <- wholeNumbers outline raw problem = p
  | isNumber needed, isNumber given, needed /= given = problem "type-mismatch" (if given `elem` ["Int", "Integer"] then trWith "This is {a given}, a whole number, but {a needed} is needed." ["given" =: given, "needed" =: needed] else trWith "This is {a given}, but {a needed} is needed." ["given" =: given, "needed" =: needed]) (conversionHint needed given)
  | isNumber needed, given == "String" = problem "type-mismatch" (trWith "This is a text, but a number (‘{needed}’) is needed." ["needed" =: needed]) (tr "Numbers are written without quotation marks.")
  | needed == "String", isNumber given || given `elem` ["Bool", "Orientation"] = problem "type-mismatch" (trWith "This is {a given}, but a text is needed." ["given" =: given]) (maybe (tr "Turn it into a text with show.") (\code -> trWith "Turn it into a text with show: {code}" ["code" =: code]) (example "show"))
  | needed == "[" <> given <> "]" = problem "type-mismatch" (trWith "This is one ‘{given}’, but a list of them is needed." ["given" =: given]) (tr "Put it in square brackets.")
  | given == "[" <> needed <> "]" = problem "type-mismatch" (trWith "This is a list, but one ‘{needed}’ is needed." ["needed" =: needed]) (tr "Take one element of it.")
  | isFunction given, not (isFunction needed), lastOf given == needed = problem "missing-argument" (trWith "Something is missing here: this still needs {a input}." ["input" =: firstOf given]) (tr "Add the missing value.")
  | "Either" : l : r : _ <- typeAtoms needed, Just side <- lookup given [(l, "Left"), (r, "Right")] = problem "missing-side" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (maybe (tr "Say which of the two it is.") (\code -> trWith "Say which of the two it is: {code}" ["code" =: code]) (example side))
  | given == "String", needed == "Say", Just rest <- Text.stripPrefix "Say " =<< source, " ++ " `Text.isInfixOf` rest = problem "operator" (trWith "Only the first text belongs to this ‘{function}’." ["function" =: "Say"]) (trWith "Put brackets around all of the text: Say ({code})" ["code" =: rest])
  | given == "Say", needed == "String" || "[" `Text.isPrefixOf` needed = problem "operator" (trWith "Only the first text belongs to this ‘{function}’." ["function" =: "Say"]) (trWith "Put brackets around all of the text: Say ({code})" ["code" =: maybe "…" (Text.strip . snd . Text.breakOnEnd "Say ") (lineAt <$> messageSpan raw)])
  | isFunction given && isFunction needed || all (`elem` commandTypes) [given, needed], Just p <- listOfDifferentTypes outline raw problem = p
  | Just c <- wrapperOf given needed = problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (maybe (trWith "Write {name} in front of it." ["name" =: c]) (\code -> trWith "Write {name} in front of it: {code}" ["name" =: c, "code" =: code]) (example c))
  | "(" `Text.isPrefixOf` given, "StdGen)" `Text.isSuffixOf` given = problem "type-mismatch" (trWith "This is a pair with a new generator, but {a needed} is needed here." ["needed" =: needed]) (maybe (tr "Take the first of the two.") (\code -> trWith "Take the first of the two: {code}" ["code" =: code]) (example "fst"))
  | isFunction needed, not (isFunction given), not (isVariable given) = problem "type-mismatch" (trWith "The type says that this takes {a input}, but nothing is taken here." ["input" =: firstOf needed]) (tr "Name what it takes on the left of the equals sign, or change the type.")
  | "rigid type variable" `Text.isInfixOf` whole = problem "too-general" (trWith "The type says that this works for any ‘{type}’, but it does not." ["type" =: (if isVariable needed then needed else given)]) (tr "Write the type that is meant instead of the small letter.")
  | isFunction given, not (isFunction needed) = problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (tr "Give the function its values, or check the brackets.")
  | otherwise = problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: given, "needed" =: needed]) (mismatchHint needed given)
  where
    said = withoutGeneratedNames (oneLine (Text.unwords (important raw)))
    whole = withoutGeneratedNames (oneLine (Text.unwords (important raw ++ context raw ++ supplementary raw)))
    user = listToMaybe . quotedParts =<< after "arising from a use of" said
    firstAtom = fromMaybe "" . listToMaybe . typeAtoms
    inner t = Text.unwords (drop 1 (typeAtoms t))
    source = messageSpan raw >>= snippet (text outline)
    example f = (\s -> f <> " " <> (if Text.any (== ' ') s && not (Text.isPrefixOf "(" s) then "(" <> s <> ")" else s)) <$> source
    -- The word that what is wrong begins with.
    firstOf' = (>>= listToMaybe . Text.words)
    equationsTooLong = do
      rest <- after "The equation(s) for ‘" whole <|> after "The equation for ‘" whole <|> after "The equations for ‘" whole
      if any (`Text.isInfixOf` rest) ["has none", "has only"] then Just (Text.takeWhile (/= '’') rest) else Nothing
    lineAt s = fromMaybe "" (listToMaybe (drop (line (start s) - 1) (Text.lines (text outline))))
    behindNot = maybe False (\s -> "not" `elem` take 1 (reverse (Text.words (Text.take (column (start s) - 1) (lineAt s))))) (messageSpan raw)
    -- What stands behind not, up to the end of the condition.
    comparison = do
      s <- messageSpan raw
      let rest = Text.drop (column (start s) - 1) (lineAt s)
          found = Text.strip (foldr (\mark t -> fst (Text.breakOn mark t)) rest [" then", " =", " &&", " ||", ")"])
      if any (`Text.isInfixOf` found) [" > ", " < ", " == ", " /= ", " >= ", " <= "] && not ("(" `Text.isInfixOf` found) then Just found else Nothing
    compared x v = x <> " == " <> v
    -- b == Pressed, where b is the whole event.
    partCompared = do
      s <- messageSpan raw
      part <- source
      (sign, x) <- case reverse (map word (tokenize (Text.take (column (start s) - 1) (lineAt s)))) of
        e : v : _ -> Just (e, v)
        _ -> Nothing
      if needed `elem` eventsWithPlaces && sign `elem` ["==", "/="] && maybe False (isLower . fst) (Text.uncons x) && (isJust (lookup part typesOfValues) || part `elem` places)
        then Just (Text.toLower needed <> (if part `elem` places then (if needed == "Button" then "Number" else "Side") else "Status") <> " " <> x <> " " <> sign <> " " <> part)
        else Nothing
    firstOf = fromMaybe "" . listToMaybe . splitArrows
    lastOf = fromMaybe "" . listToMaybe . reverse . splitArrows
    isVariable t = maybe False (isLower . fst) (Text.uncons t) && not (Text.any (== ' ') t)

    doneOutside =
      let blamed = find (any ("Done" `Text.isPrefixOf`) . outputs) (connectedTo outline)
          p = problem "done-outside-task" (maybe (tr "This gives Done, but it is not part of a task.") (\f -> trWith "‘{function}’ gives Done, but it is not part of a task." ["function" =: called f]) blamed) (tr "Remove Done, or put the function into a task: task () f")
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

    -- The function, how many values it is given, how many it takes.
    tooMany = do
      rest <- after "The function ‘" whole <|> after "The data constructor ‘" whole <|> after "The constructor ‘" whole
      taken <- countOf =<< between "is applied to " " value argument" rest
      Just (Text.takeWhile (/= '’') rest, taken, fromMaybe "none" (between "has only" "|" (Text.replace " In " "|" rest)))
    tooManyArguments f taken has
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
      | "none" == has, Just s <- source, "simulate" `elem` Text.words (maybe "" lineAt (messageSpan raw)), not (Text.any (`elem` ("()" :: String)) s) = problem "too-many-arguments" (trWith "‘{function}’ takes no values, but is given {count taken}." ["function" =: f, "taken" =# taken]) (trWith "If these are several functions, put commas between them: ({code})" ["code" =: Text.intercalate ", " (Text.words s)])
      | "none" == has || "has none" `Text.isInfixOf` whole = problem "too-many-arguments" (trWith "‘{function}’ takes no values, but is given {count taken}." ["function" =: f, "taken" =# taken]) (tr "Remove what is too much, or check the brackets.")
      | otherwise = problem "too-many-arguments" (trWith "‘{function}’ is given {count taken} values, which is too many." ["function" =: f, "taken" =# taken]) (tr "Remove what is too much, or put brackets around what belongs together.")
    overLines = maybe False (\s -> line (start s) < line (end s)) (messageSpan raw) && "do" `Text.isInfixOf` whole
