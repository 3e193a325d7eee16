{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.RobotVocabulary
-- Description : Hints about Rosy's types: syntax of their values, and Haskell equivalents of names from other languages.
module Rosy.Worker.Explanation.RobotVocabulary
  ( valueSyntaxHint,
    wrapperOf,
    typeOfValue,
    exampleOf,
    foreignNameHint,
    rosySpelling,
    rememberedHint,
    unitHint,
    haskellSpelling,
    loopWords,
    robotNames,
    places,
    eventsWithPlaces,
    readyTasks,
    taskSynonyms,
    robotLimits,

    -- * Hints
    isNumber,
    conversionHint,
    numberMismatchHint,
    mismatchHint,
    addMissing,
  )
where

import Control.Applicative ((<|>))
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText (Type)
import Rosy.Worker.Explanation.OriginalVocabulary (originalNameHint)
import Rosy.Worker.Explanation.RobotTypes (commandTypes, sensedOnly, typesOfPlaces, typesOfValues)
import Rosy.Worker.Sentence

-- | Syntax of the values of a type.
valueSyntaxHint :: Text -> Maybe Sentence
valueSyntaxHint t = lookup t valueSyntax

valueSyntax :: [(Text, Sentence)]
valueSyntax =
  [ ("BumperSide", tr "It is LeftBumper, CenterBumper or RightBumper."),
    ("CliffSide", tr "It is LeftCliff, CenterCliff or RightCliff."),
    ("WheelSide", tr "It is LeftWheel or RightWheel."),
    ("ButtonNumber", tr "It is Button0, Button1 or Button2."),
    ("ButtonStatus", tr "It is Pressed or Released."),
    ("CliffStatus", tr "It is Hole or Floor."),
    ("WheelStatus", tr "It is Air or Ground."),
    ("RobotStatus", tr "It is Online or Offline."),
    ("LedColor", tr "It is Black, Green, Orange or Red."),
    ("Sound", tr "It is a sound such as ErrorSound or ButtonSound."),
    ("Bumper", tr "Write it with both its parts, for example: (Bumper LeftBumper Pressed)"),
    ("Cliff", tr "Write it with both its parts, for example: (Cliff LeftCliff Hole)"),
    ("Wheel", tr "Write it with both its parts, for example: (Wheel LeftWheel Air)"),
    ("Button", tr "Write it with both its parts, for example: (Button Button0 Pressed)"),
    ("Velocity", tr "Write it with both its parts, for example: (Velocity 0.5 0)"),
    ("Clock", tr "Take it apart with a pattern: (Clock h m s ms)"),
    ("Position", tr "Write it with both its parts, for example: (Position x y)")
  ]

-- | The constructor that converts the first type to the second.
wrapperOf :: Text -> Text -> Maybe Text
wrapperOf given needed
  | given == "LedColor", needed `elem` ["Led1", "Led2"] = Just needed
  | given == "String", needed == "Say" = Just "Say"
  | otherwise = Nothing

-- | The type to use instead of a value.
typeOfValue :: Text -> Maybe Sentence
typeOfValue v = sensed <|> named
  where
    sensed = (\t -> trWith "To sense only this one, write {type}" ["type" =: t]) <$> lookup v typesOfPlaces
    named = (\t -> trWith "Its type is called {type}" ["type" =: t]) <$> lookup v typesOfValues

-- | Types and constructors of the robot that these tables know.
robotNames :: [Text]
robotNames = map fst valueSyntax ++ places ++ map fst typesOfValues ++ commandTypes

-- | Values for a place of the robot: @LeftBumper@.
places :: [Text]
places = map fst typesOfPlaces

-- | Events with a place and a state, as @Bumper@; that of one place is named after it, as @BumperLeft@.
eventsWithPlaces :: [Text]
eventsWithPlaces = [t | t <- sensedOnly, any (\(_, ofPlace) -> t `Text.isPrefixOf` ofPlace && t /= ofPlace) typesOfPlaces]

-- | The ready-made tasks that are steps of a program, with the number of values that each takes.
readyTasks :: [(Text, Int)]
readyTasks = [("drive", 1), ("turn", 1), ("wait", 1), ("say", 1), ("blink", 1), ("beep", 0), ("driveUntilBump", 0), ("penDown", 0), ("penUp", 0), ("penColor", 1), ("penWidth", 1)]

-- | Highest speed, m\/s, and turn, rad\/s: the @limits@ of the simulated robot in @protocol/robots@, which a test compares. The worker is built without the
-- library's table of robots.
robotLimits :: (Double, Double)
robotLimits = (0.7, 3.141592653589793)

-- | A complete example of a type constructor.
exampleOf :: Text -> Text
exampleOf t = fromMaybe (t <> " Double") (lookup t [("Memory", "Memory Bool"), ("Param", "Param Int"), ("Task", "Task ()"), ("Done", "Done ()"), ("Maybe", "Maybe Sound"), ("Either", "Either Bumper Cliff")])

-- | The Rosy equivalent of a name from other languages.
foreignNameHint :: Text -> Maybe Sentence
foreignNameHint n
  | Just here <- originalNameHint n = Just here
  | Just phrase <- lookup n phrases = Just phrase
  | Just ours <- lookup n operators = Just (trWith "In Haskell this is written {code}" ["code" =: ours])
  | Just sound <- soundCalled n = Just (trWith "Did you mean {or names}?" ["names" =* [sound]])
  | n `elem` map ("Led" <>) ["Red", "Green", "Orange", "Black"] ++ ["Blue", "Yellow", "White", "Purple", "Pink", "Off"] = Just (tr "A light can be Black, which is off, Green, Orange or Red.")
  | Just ours <- haskellSpelling n = Just (trWith "In Haskell this is written {code}" ["code" =: ours])
  | Just ours <- lookup n taskSynonyms = Just (trWith "In Rosy this is called {name}" ["name" =: ours])
  | n `elem` loopWords = Just (tr "Functions fire again and again by themselves; to repeat a task, write forever or replicateM_ 4")
  | n == "Main" = Just (tr "A program starts at main, with a small letter.")
  | n `elem` ["O", "o"] = Just (tr "If the number is meant, write 0")
  | n `elem` ["true", "false", "TRUE", "FALSE"] = Just (tr "Write True or False.")
  | n `elem` ["null", "None", "nil", "nothing"] = Just (tr "If there is nothing to give, write Nothing.")
  | otherwise = Nothing
  where
    operators = [("!=", "/="), ("<>=", ">="), ("=<", "<="), ("=>", ">="), ("===", "=="), ("&", "&&"), ("and", "&&"), ("or", "||"), ("elif", "else if"), ("elseif", "else if")]
    phrases =
      [ ("%", trWith "In Haskell this is written with the word mod in front of both numbers, for example: {code}" ["code" =: "mod 7 2"]),
        ("//", trWith "In Haskell this is written with the word div in front of both numbers, for example: {code}" ["code" =: "div 7 2"]),
        ("+=", tr "In Haskell this is written with a new value: Memory (n + 1)"),
        ("-=", tr "In Haskell this is written with a new value: Memory (n - 1)"),
        ("++=", tr "In Haskell this is written with a new value."),
        ("print", tr "In Haskell this is written with Say."),
        ("right", tr "To turn to the right, write a negative number: turn (-90)")
      ]

-- | Rosy's name for what another name means, where it takes the same values.
rosySpelling :: Text -> Maybe Text
rosySpelling n = haskellSpelling n <|> soundCalled n <|> lookup n taskSynonyms

-- | Names of tasks in other languages and libraries, and Rosy's.
taskSynonyms :: [(Text, Text)]
taskSynonyms = [(theirs, ours) | (ours, names) <- [("drive", "forward forwards move go ahead fahre avance avanza"), ("turn", "rotate spin left drehe tourne gira"), ("wait", "sleep delay pause"), ("say", "speak echo write tell"), ("simulate", "run start execute launch")], theirs <- Text.words names]

-- | @ErrorSound@ for @Error@.
soundCalled :: Text -> Maybe Text
soundCalled n = case [v | (v, _) <- typesOfValues, "Sound" `Text.isSuffixOf` v, Text.dropEnd 5 v == n] of
  [sound] -> Just sound
  _ -> Nothing

-- | What to write in place of a second value for this name.
rememberedHint :: Text -> Sentence
rememberedHint name = trWith "A value that changes is kept in a Memory. Write in place of ‘{name}’, for example: {code}, and below it: {other}, and then: {main}" ["name" =: name, "main" =: "main = simulate count", "code" =: "count :: Memory Int -> Bumper -> (Memory Int, Say)", "other" =: "count (Memory n) _ = (Memory (n + 1), Say (show n))"]

-- | Replacement of a unit behind a number.
unitHint :: Text -> Maybe Sentence
unitHint n
  | n `elem` ["degrees", "degree", "deg"] = Just (tr "Write: degreesToRadians 90, or degreesToOrientation 90")
  | n `elem` ["cm", "centimeters", "centimetres"] = Just (tr "Lengths are in metres: write centimetersToMeters 50, or 0.5")
  | n `elem` ["ms", "milliseconds"] = Just (tr "Times are in seconds: write 0.5 for half a second.")
  | n `elem` ["s", "sec", "secs", "second", "seconds", "m", "meters", "metres", "rad", "radians"] = Just (trWith "Remove ‘{name}’: times are in seconds, lengths in metres, angles in radians." ["name" =: n])
  | otherwise = Nothing

-- | Haskell spelling of a name from other languages.
haskellSpelling :: Text -> Maybe Text
haskellSpelling n = lookup n [("Number", "Double"), ("Num", "Double"), ("Boolean", "Bool"), ("Str", "String"), ("Text", "String"), ("PI", "pi"), ("Pi", "pi"), ("Void", "()")]

-- | Loop keywords of other languages.
loopWords :: [Text]
loopWords = ["for", "while", "loop"]

-- | Hint for a number in place of this type.
numberMismatchHint :: Type -> Sentence
numberMismatchHint t
  | "Task" `Text.isPrefixOf` t = tr "To give a name to a value in a task, write: let x = 3"
  | t == "Bool" = tr "Write True or False."
  | t == "String" = tr "Put it in quotation marks, or turn it into a text with show."
  | otherwise = fromMaybe (tr "Check which value belongs here.") (valueSyntaxHint t)

-- | Whether a type is numeric.
isNumber :: Type -> Bool
isNumber t = t `elem` ["Int", "Integer", "Double", "Float", "Seconds", "Orientation", "Word", "Rational", "Degrees", "Radians", "Centimeters", "Meters"]

-- | Conversion between numeric types: expected, actual.
conversionHint :: Type -> Type -> Sentence
conversionHint needed given
  | whole' given, whole' needed = tr "Convert it with fromIntegral."
  | whole' given = tr "Convert it with fromIntegral."
  | whole' needed = tr "Round it with round."
  | needed == "Seconds" = tr "Convert it with doubleToSeconds."
  | given == "Seconds" = tr "Convert it with secondsToDouble."
  | given == "Orientation" = tr "Take the number out with a pattern: (Orientation r)"
  | needed == "Orientation" = tr "Write Orientation in front of it."
  | otherwise = tr "Convert it with realToFrac."
  where
    whole' t = t `elem` ["Int", "Integer", "Word"]

-- | Hint for a mismatch: expected, actual.
mismatchHint :: Type -> Type -> Sentence
mismatchHint needed given
  | all isCommand [needed, given] = tr "A function gives one type of command: use Either, Maybe or a pair for several."
  | otherwise = fromMaybe (tr "Check which of the two was meant.") (valueSyntaxHint needed)
  where
    isCommand = (`elem` commandTypes)

-- | Hint for a function or constructor that needs another value.
addMissing :: Text -> Sentence
addMissing f = maybe (tr "Add what is missing.") (\code -> trWith "Write, for example: {code}" ["code" =: code]) (lookup f examples)
  where
    examples = [("Velocity", "Velocity 0.5 0"), ("Bumper", "Bumper LeftBumper Pressed"), ("Led1", "Led1 Green"), ("Led2", "Led2 Green"), ("Position", "Position 1 0")]
