{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.MismatchCauses
-- Description : Type mismatches whose cause is visible in the text.
--
-- Recognises, for example, a dot for a field, commas between arguments, and a pattern without its constructor. These checks come before
-- the types are compared.
module Rosy.Worker.Explanation.MismatchCauses
  ( mismatchCause,
    partialConstructor,
    unbracketedCalculation,
  )
where

import Data.Char (isAlphaNum, isDigit, isLower, isSpace, isUpper)
import Data.List (tails)
import Data.Maybe (fromMaybe, isNothing, listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.Mismatch
import Rosy.Worker.Explanation.RobotTypes (commandTypes, typesOfPlaces, typesOfValues)
import Rosy.Worker.Explanation.RobotVocabulary (addMissing, eventsWithPlaces, isNumber)
import Rosy.Worker.Explanation.TextRepair (lineAfter)
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | The textual cause of a mismatch, if any.
mismatchCause :: Rule
mismatchCause m = listToMaybe (concatMap ($ m) causes)

-- | The first that applies explains the message.
causes :: [Mismatch -> [Problem]]
causes = [fieldBehindDot, minusOfSubtraction, pairAsPattern, commasBetweenArguments, unfinishedConstructor, joinedNumber, typeOfMain, partAsPattern, bareValueAsPattern, misplacedTask]

-- * Causes

-- | A field behind a dot, as in @r.speed@.
fieldBehindDot :: Mismatch -> [Problem]
fieldBehindDot Mismatch {..} =
  [ (problem "operator" (tr "A value has no parts after a dot.") (trWith "To take a field, write its name in front: {field} {owner}" ["field" =: field, "owner" =: owner])) {place = Just (Span (Position (line (start s)) from) (Position (line (start s)) upTo))}
    | Just s <- [messageSpan raw],
      (owner, field, from, upTo) <- dots (lineAt outline s),
      from <= column (end s),
      upTo >= column (start s),
      isField outline field
  ]

isField :: ProgramOutline -> Text -> Bool
isField outline f = any (\l -> any (`Text.isInfixOf` l) [f <> " ::", f <> "::"] && any (`Text.isInfixOf` l) ["{", ","]) (Text.lines (text outline))

-- | A negative number without brackets, which GHC reads as a subtraction, as in @Velocity 0 -0.5@.
minusOfSubtraction :: Mismatch -> [Problem]
minusOfSubtraction Mismatch {..} =
  [ (problem "negative-number" (tr "Here minus takes one thing from another.") (trWith "A negative number needs brackets: (-{number})" ["number" =: n])) {place = Just (Span (Position (line (start s)) i) (Position (line (start s)) (i + 1)))}
    | isFunction given,
      not (isFunction needed),
      Just s <- [messageSpan raw],
      (left, right) <- take 1 (Text.breakOnAll " -" (lineAt outline s)),
      any (maybe False (isUpper . fst) . Text.uncons) (Text.words left),
      let n = Text.takeWhile (\c -> isAlphaNum c || c `elem` ("._'" :: String)) (Text.drop 2 right),
      not (Text.null n),
      let i = Text.length left + 2
  ]

-- | A pair in place of a constructor, as in @drive (v, w) = …@.
pairAsPattern :: Mismatch -> [Problem]
pairAsPattern m@Mismatch {..} =
  [ problem "pattern" (trWith "This takes {a needed}, but the pattern is a pair." ["needed" =: needed]) (trWith "Write the pattern as ({code})" ["code" =: Text.unwords (needed : parts)])
    | isPattern m,
      needed `elem` ["Velocity", "Position"],
      "(" `Text.isPrefixOf` given,
      Just s <- [source],
      Just inside <- [Text.stripPrefix "(" s >>= Text.stripSuffix ")"],
      let parts = map Text.strip (Text.splitOn "," inside),
      length parts == 2
  ]

-- | Commas between arguments, as in @add(v, 0.5)@.
commasBetweenArguments :: Mismatch -> [Problem]
commasBetweenArguments Mismatch {..} =
  [ problem "arguments-with-commas" (tr "Values follow a function without commas.") (trWith "Write: {code}" ["code" =: Text.unwords (f : map argument parts)])
    | "(" `Text.isPrefixOf` given,
      "," `Text.isInfixOf` given,
      not ("(" `Text.isPrefixOf` needed),
      Just s <- [source],
      Just inside <- [Text.stripPrefix "(" s >>= Text.stripSuffix ")"],
      let parts = map Text.strip (Text.splitOn "," inside),
      not (any (Text.any (`elem` ("([" :: String))) parts),
      let f = Text.takeWhileEnd (\c -> isAlphaNum c || c `elem` ("_'" :: String)) (Text.stripEnd before),
      not (Text.null f)
  ]

-- | A constructor without all its values, as in @Memory (Turn 1.5)@, where Turn needs one more.
unfinishedConstructor :: Mismatch -> [Problem]
unfinishedConstructor Mismatch {..} =
  [ missing c (init (splitArrows (stripped (inner given))))
    | firstAtom given == firstAtom needed,
      firstAtom given `elem` ["Memory", "Param", "Maybe", "Done"],
      let parts = splitArrows (stripped (inner given)),
      length parts > 1,
      last parts == stripped (inner needed),
      Just s <- [source],
      c : _ <- [drop 1 (Text.words (Text.filter (`notElem` ("()" :: String)) s))]
  ]
  where
    missing c rest = problem "missing-argument" (if length rest == 1 then trWith "‘{function}’ needs another value: {then types}." ["function" =: c, "types" =* rest] else trWith "‘{function}’ needs more values: {then types}." ["function" =: c, "types" =* rest]) (addMissing c)

-- | A number beside @++@.
joinedNumber :: Mismatch -> [Problem]
joinedNumber Mismatch {..} =
  [ problem "operator" (trWith "‘++’ puts texts and lists together, but this is {a given}." ["given" =: given]) (tr "To add numbers, write +")
    | "[" `Text.isPrefixOf` needed || needed == "String",
      isNumber given,
      any (`Text.isInfixOf` (" " <> before <> behind)) ["++"],
      "++" `Text.isPrefixOf` Text.stripStart behind && not ("\"" `Text.isInfixOf` behind)
  ]
    ++ [ problem "operator" (trWith "‘++’ puts texts and lists together, but this is {a given}." ["given" =: needed]) (tr "To add numbers, write +")
         | isNumber needed,
           "[" `Text.isPrefixOf` given,
           Just s <- [source],
           " ++ " `Text.isInfixOf` s,
           not ("\"" `Text.isInfixOf` s)
       ]

-- | A type of main that is not IO.
typeOfMain :: Mismatch -> [Problem]
typeOfMain Mismatch {..} =
  [ (problem "main-type" (tr "The type of ‘main’ is IO ().") (tr "Write main :: IO (), or leave that line out.")) {place = lookup "main" (signatures outline)}
    | "IO" == firstAtom given,
      "main" `elem` take 1 (Text.words (Text.stripStart before)),
      Just _ <- [lookup "main" (signatures outline)]
  ]

-- | Only a part of an event, as in @f Pressed = …@, where f takes a Bumper.
partAsPattern :: Mismatch -> [Problem]
partAsPattern m@Mismatch {..} =
  [ (problem "pattern" (trWith "‘{part}’ is only a part of a ‘{event}’." ["part" =: part, "event" =: needed]) (lineAfter [repair] (text outline) (start s))) {fixes = [Fix (trWith "Write {code}" ["code" =: full]) [repair]]}
    | isPattern m,
      needed `elem` eventsWithPlaces,
      Just s <- [messageSpan raw],
      Just part <- [Text.dropAround (`elem` ("( )" :: String)) <$> source],
      Just full <- [if given `elem` [needed <> "Side", needed <> "Number"] && part `elem` map fst typesOfPlaces then Just (needed <> " " <> part <> " _") else if lookup part typesOfValues == Just given && (given == needed <> "Status" || (needed, given) == ("Bumper", "ButtonStatus")) then Just (needed <> " _ " <> part) else Nothing],
      let repair = Edit s (if "(" `Text.isSuffixOf` before && ")" `Text.isPrefixOf` behind then full else "(" <> full <> ")")
  ]

-- | A pattern without the constructor around it.
bareValueAsPattern :: Mismatch -> [Problem]
bareValueAsPattern m@Mismatch {..} =
  [ problem k sentence (trWith "Write the pattern as ({code})" ["code" =: c <> " " <> s'])
    | isPattern m,
      (c, k, sentence) <- [("Memory", "missing-memory", trWith "This takes a whole Memory, but the pattern is that of {a given}." ["given" =: given]), ("Just", "missing-just", tr "The type says that this may be missing, but the pattern does not.")],
      firstAtom needed == (if c == "Just" then "Maybe" else c),
      stripped (inner needed) == given,
      Just s <- [source],
      let s' = if Text.any isSpace s && not ("(" `Text.isPrefixOf` s) then "(" <> s <> ")" else s
  ]

-- | A task where a function is needed, or a command where a task is.
misplacedTask :: Mismatch -> [Problem]
misplacedTask Mismatch {..}
  | isFunction given, isFunction needed, w : _ <- filter (`elem` ["when", "unless"]) (Text.words line'), "()" `elem` map (last . splitArrows) [given, needed] = [(problem "too-many-arguments" (trWith "‘{word}’ takes two things: a condition and a task." ["word" =: w]) (trWith "Put brackets around the task: {code}" ["code" =: whenWithBrackets w])) {place = wordPlace w}]
  | source == Just "say", isFunction needed, input : _ <- splitArrows needed, input /= "String" = [problem "type-mismatch" (trWith "‘say’ takes a text, but here it is given {a type}." ["type" =: input]) (tr "Turn it into a text first: say . show")]
  | firstAtom given == "Task", isFunction needed, last (splitArrows needed) `elem` ["res", "see"] = [problem "controller-needed" (tr "This is a task, but here is the place of a function that gives a command.") (tr "Write for example: \\_ -> Say \"done\"")]
  | openEnded, given `elem` commandTypes = [problem "task-needed" (trWith "A task is needed here, but this is {a given}." ["given" =: given]) (maybe (tr "Turn a command into a task with once.") (\s -> trWith "Turn a command into a task with once: {code}" ["code" =: "once " <> argument s]) source)]
  | firstAtom needed /= "Task" = []
  | given == "String" = [problem "task-needed" (tr "A task is needed here, but this is a text.") (maybe (tr "To show it, write say in front of it.") (\s -> trWith "To show it, write say in front of it: {code}" ["code" =: "say " <> s]) source)]
  | "[Task" `Text.isPrefixOf` given, Just rest <- Text.stripPrefix "replicate " =<< source = [problem "task-needed" (tr "One task is needed here, but this is a list of them.") (trWith "To repeat a task, write: {code}" ["code" =: ("replicateM_ " <> rest)])]
  | "[Task" `Text.isPrefixOf` given = [problem "task-needed" (tr "One task is needed here, but this is a list of them.") (tr "Take them out of the list; sequence_ makes one task of a list, and replicateM_ does one several times.")]
  | given == "Call" = [problem "task-needed" (tr "A task is needed here, but this is a ‘Call’.") (tr "In a task, write the called task itself, without call.")]
  | otherwise = []
  where
    whenWithBrackets w = case Text.words (snd (Text.breakOn (w <> " ") line')) of
      _ : c : rest@(_ : _) | not (Text.any (`elem` ("()$" :: String)) (Text.unwords (c : rest))) -> Text.unwords [w, c, "(" <> Text.unwords rest <> ")"]
      _ -> w <> " c (say \"yes\")"
    -- f a, where nothing says more.
    openEnded = length (typeAtoms needed) == 2 && maybe False (isLower . fst) (Text.uncons (firstAtom needed)) && not (isFunction needed)
    line' = maybe "" (lineAt outline) (messageSpan raw)
    wordPlace w = do
      s <- messageSpan raw
      let from = Text.length (fst (Text.breakOn (w <> " ") line')) + 1
      Just (Span (Position (line (start s)) from) (Position (line (start s)) (from + Text.length w)))

-- * Parts of the program

-- | Whether this stands before the equals sign or the arrow of a case.
isPattern :: Mismatch -> Bool
isPattern Mismatch {..} = not (any (`elem` ["=", "->", "<-", "|"]) (Text.words before)) && any (`elem` ["=", "->", "|", "<-"]) (Text.words behind)

-- | In brackets, if it would not be one argument without them.
argument :: Text -> Text
argument t = if Text.any isSpace t || "-" `Text.isPrefixOf` t then "(" <> t <> ")" else t

-- | A type without the brackets around it.
stripped :: Type -> Type
stripped t = fromMaybe t (Text.stripPrefix "(" t >>= Text.stripSuffix ")")

-- | The names directly around each dot of a line, with the start and end column.
dots :: Text -> [(Text, Text, Int, Int)]
dots l = mapMaybe at [i | (i, '.') <- zip [0 ..] (Text.unpack l)]
  where
    at i =
      let owner = Text.takeWhileEnd isName (Text.take i l)
          field = Text.takeWhile isName (Text.drop (i + 1) l)
          begins p t = maybe False (p . fst) (Text.uncons t)
       in if begins isLower owner && begins isLower field then Just (owner, field, i + 1 - Text.length owner, i + 2 + Text.length field) else Nothing
    isName c = isAlphaNum c || c `elem` ("_'" :: String)

-- | The partially applied constructor of a definition without a signature, as in @go = Velocity 0.5@.
partialConstructor :: ProgramOutline -> Text -> Maybe (Text, Span)
partialConstructor outline name = do
  s <- lookup name (bindings outline)
  if isNothing (lookup name (signatures outline)) then Just () else Nothing
  body <- snippetOf s
  rest <- Text.stripPrefix name body >>= Text.stripPrefix "=" . Text.stripStart
  c <- listToMaybe (Text.words rest)
  if maybe False (isUpper . fst) (Text.uncons c) then Just (c, s) else Nothing
  where
    snippetOf s
      | line (start s) == line (end s) = Just (Text.take (column (end s) - column (start s)) (Text.drop (column (start s) - 1) (Text.splitOn "\n" (text outline) !! (line (start s) - 1))))
      | otherwise = Nothing

-- | A constructor, and the calculation among its arguments that needs brackets, as in @Velocity 0 pi/2@ and @Velocity v * 2 0@.
unbracketedCalculation :: Text -> Maybe (Text, Text)
unbracketedCalculation = listToMaybe . mapMaybe behind . tails . Text.words
  where
    behind ws = case ws of
      c : values | startsWith isUpper c, Text.all isAlphaNum c -> (,) c <$> listToMaybe (mapMaybe touching (takeWhile plain values) ++ apart (takeWhile plain values))
      _ -> Nothing
    touching w = case Text.break (`elem` signs) w of
      (x, more) | not (Text.null x), startsWith isValue (Text.drop 1 more) -> Just w
      _ -> Nothing
    apart values = case values of
      x : sign : y : _ | Text.length sign == 1, Text.all (`elem` signs) sign, startsWith isValue y -> [Text.unwords [x, sign, y]]
      _ -> []
    plain = Text.all (\c -> isAlphaNum c || c `elem` ("._'" :: String) || c `elem` signs)
    startsWith p = maybe False (p . fst) . Text.uncons
    isValue c = isLower c || isDigit c
    signs = "+*/" :: String
