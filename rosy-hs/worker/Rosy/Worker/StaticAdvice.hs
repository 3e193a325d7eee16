{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.StaticAdvice
-- Description : Notes about correct programs: what can never happen, and what has no effect.
--
-- Takes the functions of a program with their inputs and outputs, and facts of its syntax tree. Types cannot tell that nothing sends an event or
-- that a memory is never written. A note is given only where this is certain: not where a function is unknown by name, has an open type, or
-- runs in a task. Pure.
module Rosy.Worker.StaticAdvice
  ( Facts (..),
    DeclaredType (..),
    Constructor (..),
    staticAdvice,
  )
where

import Control.Applicative ((<|>))
import Data.Char (isAlphaNum, isLower)
import Data.List (sortOn)
import Data.Maybe (isNothing, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage (ProgramOutline (..))
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.Tokenizer (Token (..), tokenSpan, tokenize)
import Rosy.Worker.Explanation.TypeMessages (typePlace)
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | What the syntax tree tells.
data Facts = Facts
  { declaredTypes :: [DeclaredType],
    -- | Constructors of these types that an expression builds.
    built :: [Text],
    -- | Constructors of these types in patterns, with their places.
    matched :: [(Text, Span)],
    -- | The names of all functions given to the robot.
    connectedNames :: [Text],
    -- | Those of them that the program applies to arguments, so that not every argument is an input.
    appliedNames :: [Text],
    -- | Worlds that the program names for @simulateIn@, with their places.
    namedWorlds :: [(Text, Span)]
  }

-- | A @data@ or @newtype@ of the program.
data DeclaredType = DeclaredType
  { typeName :: Text,
    constructors :: [Constructor],
    -- | Whether values can come from elsewhere than constructors in expressions: derived classes such as @Enum@, instances of @Sensor@.
    hasOtherSources :: Bool,
    -- | Whether an instance of @Command@ says where values go to.
    hasOtherTargets :: Bool
  }

-- | A constructor, and the names of the types of its fields.
data Constructor = Constructor {constructorName :: Text, fieldTypes :: [Text]}

-- | The program as the robot runs it.
data Network = Network
  { outline :: ProgramOutline,
    facts :: Facts,
    -- | The functions as written, and with their types spelled out.
    connections :: [(Function, Function)],
    -- | The types of all outputs.
    given :: [Text],
    -- | The types of all inputs.
    taken :: [Text],
    -- | Whether each connected function is known, with closed types.
    isComplete :: Bool
  }

networkOf :: ProgramOutline -> Facts -> Network
networkOf outline facts = Network {..}
  where
    connections = zip (connectedTo outline) (spelledOut outline)
    given = concatMap (outputs . snd) connections
    taken = concatMap (inputs . snd) connections
    isComplete = not (null connections) && all (`elem` map (called . fst) connections) (connectedNames facts) && not (any isUnknown (given ++ taken))
    isUnknown t = any (\w -> w `elem` ["Task", "Call", "IO", "forall"] || maybe False (isLower . fst) (Text.uncons w)) (wordsOf t)

-- | In the order of the text.
staticAdvice :: ProgramOutline -> Facts -> [Problem]
staticAdvice outline facts = sortOn place (ofFunctions ++ sentByMain outline facts ++ filter ((`notElem` map function ofFunctions) . function) (impossibleCases outline facts) ++ ignoredWorlds outline facts)
  where
    ofFunctions = concatMap ($ networkOf outline facts) [neverSent, neverTaken, neverWritten, neverRead]

-- * Events and memories of functions

-- | An event that a function takes and nothing sends.
neverSent :: Network -> [Problem]
neverSent network@Network {..} =
  [ note outline f written "never-sent" (trWith "Nothing sends ‘{type}’, which ‘{function}’ takes." ["type" =: written, "function" =: called f]) (if isRequired outline f written then trWith "So ‘{function}’ never fires. Give ‘{type}’ in another function." ["function" =: called f, "type" =: written] else trWith "So this never happens. Give ‘{type}’ in another function." ["type" =: written])
    | (f, written, t) <- each network inputs,
      called f `notElem` appliedNames facts,
      Just d <- [eventOf facts t],
      not (hasOtherSources d),
      isComplete && t `notElem` given || not (isBuilt facts d)
  ]

-- | An event that a function sends and no function takes.
neverTaken :: Network -> [Problem]
neverTaken network@Network {..} =
  [ note outline f written "never-taken" (trWith "‘{function}’ sends ‘{type}’, and no function takes it." ["function" =: called f, "type" =: written]) (trWith "So nothing follows from it. Take ‘{type}’ in another function." ["type" =: written])
    | isComplete,
      (f, written, t) <- each network outputs,
      Just d <- [eventOf facts t],
      not (hasOtherTargets d),
      t `notElem` taken
  ]

-- | A memory that a function reads and no function writes.
neverWritten :: Network -> [Problem]
neverWritten network@Network {..} =
  [ note outline f written "never-written" (trWith "‘{function}’ reads ‘{type}’, and no function writes it." ["function" =: called f, "type" =: written]) (trWith "So it never changes. Give ‘{type}’ in a function." ["type" =: written])
    | isComplete,
      (f, written, t) <- each network inputs,
      called f `notElem` appliedNames facts,
      isMemory facts t,
      t `notElem` given
  ]

-- | A memory that a function writes and no function reads.
neverRead :: Network -> [Problem]
neverRead network@Network {..} =
  [ note outline f written "never-read" (trWith "‘{function}’ writes ‘{type}’, and no function reads it." ["function" =: called f, "type" =: written]) (trWith "So it changes nothing. Take ‘{type}’ in a function." ["type" =: written])
    | isComplete,
      (f, written, t) <- each network outputs,
      isMemory facts t,
      t `notElem` taken
  ]

note :: ProgramOutline -> Function -> Text -> Text -> Sentence -> Sentence -> Problem
note outline f t k m h = (problemAt (Span (Position 1 1) (Position 1 1)) k m h) {severity = Note, function = Just (called f), place = typePlace outline (called f) t <|> lookup (called f) (bindings outline)}

-- | Each input or output as written and spelled out, with its function.
each :: Network -> (Function -> [Text]) -> [(Function, Text, Text)]
each Network {..} which = [(f, written, t) | (f, full) <- connections, (written, t) <- zip (which f) (which full)]

-- | The declaration of an event.
eventOf :: Facts -> Text -> Maybe DeclaredType
eventOf facts t = listToMaybe [d | d <- declaredTypes facts, Just (typeName d) == listToMaybe (wordsOf t)]

isBuilt :: Facts -> DeclaredType -> Bool
isBuilt facts d = any ((`elem` built facts) . constructorName) (constructors d)

-- | Whether a function never fires without an input.
isRequired :: ProgramOutline -> Function -> Text -> Bool
isRequired outline f t = maybe False ((t `elem`) . init . splitArrows) (lookup (called f) (typesOfNames outline))

isMemory :: Facts -> Text -> Bool
isMemory facts t = any (`Text.isPrefixOf` t) ["Memory ", "Param "] && null (eventOf facts t)

wordsOf :: Text -> [Text]
wordsOf = Text.words . Text.map (\c -> if isAlphaNum c || c `elem` ("_'" :: String) then c else ' ')

-- * The rest of the program

-- | A value in main itself, as in @simulate Knock@, which no function takes.
sentByMain :: ProgramOutline -> Facts -> [Problem]
sentByMain outline facts =
  [ (uncurry (problemAt (tokenSpan t) "never-taken") (unanswered (typeName d) (map word (drop 3 whole)))) {severity = Note, function = Just "main"}
    | Just within <- [lookup "main" (bindings outline)],
      d <- declaredTypes facts,
      not (hasOtherTargets d),
      all ((`notElem` map fst (matched facts)) . constructorName) (constructors d),
      not (any (elem (typeName d) . wordsOf . snd) [x | x@(name, _) <- typesOfNames outline, name /= "main", Text.all isLower (Text.take 1 name)]),
      let whole = [t | t <- tokenize (text outline), from t >= start within, from t < end within],
      t : _ <- [[t | t <- whole, word t `elem` map constructorName (constructors d)]]
  ]

-- | The sentences about it. Takes the type of the value and the words behind @main = simulate@.
unanswered :: Text -> [Text] -> (Sentence, Sentence)
unanswered t argument = case argument of
  [value] ->
    ( trWith "‘{type}’ is only an event: alone, it makes the robot do nothing." ["type" =: t],
      trWith "Write a function that takes it, for example: {code}, and below it: {equation}. Then put both into simulate: {other}" ["code" =: answer, "equation" =: equation, "other" =: ("main = simulate (" <> value <> ", answer)")]
    )
  _ ->
    ( trWith "No function takes ‘{type}’, so it has no effect." ["type" =: t],
      trWith "Write a function that takes it, for example: {code}, and below it: {equation}. Then give it to simulate as well." ["code" =: answer, "equation" =: equation]
    )
  where
    answer = "answer :: " <> t <> " -> Sound"
    equation = "answer _ = ErrorSound"

-- | A case of a value that nothing makes.
impossibleCases :: ProgramOutline -> Facts -> [Problem]
impossibleCases outline facts =
  [ (problemAt s "impossible-case" (tr "This case cannot occur.") (trWith "Nothing in the program makes ‘{name}’." ["name" =: c])) {severity = Note, function = listToMaybe [n | (n, within) <- bindings outline, start within <= start s, end s <= end within]}
    | (c, s) <- matched facts,
      c `notElem` built facts,
      d <- declaredTypes facts,
      not (hasOtherSources d),
      not (any ((typeName d `elem`) . fieldTypes) (constructors d)),
      (before, _ : _) <- [break ((== c) . constructorName) (constructors d)],
      -- A memory may start with the first constructor that has a default.
      any (all (`elem` withDefault) . fieldTypes) before
  ]
  where
    withDefault = ["Bool", "Char", "Double", "Float", "Int", "Integer", "Seconds", "String"]

-- | A world that the program names, which has no effect.
ignoredWorlds :: ProgramOutline -> Facts -> [Problem]
ignoredWorlds outline facts =
  [ (problemAt s "ignored-world" (trWith "‘{word}’ has no effect: the room is chosen in the page, or with --world." ["word" =: w]) (tr "So the program runs in every room and on real robots. ‘simulate’ does the same.")) {severity = Note, function = Just "main"}
    | isNothing (lookup "simulateIn" (bindings outline)),
      (w, s) <- namedWorlds facts
  ]
