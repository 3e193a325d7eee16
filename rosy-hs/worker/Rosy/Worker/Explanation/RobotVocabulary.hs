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
    unitHint,
    haskellSpelling,
    loopWords,

    -- * Hints
    isNumber,
    conversionHint,
    numberMismatchHint,
    mismatchHint,
  )
where

import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText (Type)
import Rosy.Worker.Explanation.OriginalVocabulary (originalNameHint)
import Rosy.Worker.Sentence

-- | Syntax of the values of a type.
valueSyntaxHint :: Text -> Maybe Sentence
valueSyntaxHint t = lookup t table
  where
    table =
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
        ("Bumper", tr "Write it with both its parts, for example: (Bumper LeftBumper Pressed)."),
        ("Cliff", tr "Write it with both its parts, for example: (Cliff LeftCliff Hole)."),
        ("Wheel", tr "Write it with both its parts, for example: (Wheel LeftWheel Air)."),
        ("Button", tr "Write it with both its parts, for example: (Button Button0 Pressed)."),
        ("Velocity", tr "Write it with both its parts, for example: (Velocity 0.5 0)."),
        ("Clock", tr "Take it apart with a pattern: (Clock h m s ms)."),
        ("Position", tr "Write it with both its parts, for example: (Position x y).")
      ]

-- | The constructor that converts the first type to the second.
wrapperOf :: Text -> Text -> Maybe Text
wrapperOf given needed
  | given == "LedColor", needed `elem` ["Led1", "Led2"] = Just needed
  | given == "String", needed == "Say" = Just "Say"
  | otherwise = Nothing

-- | The type to use instead of a value.
typeOfValue :: Text -> Maybe Sentence
typeOfValue v = lookup v (sides ++ parts)
  where
    sides =
      [ (value, trWith "To sense only this one, write {type}." ["type" =: t])
        | (value, t) <-
            [ ("LeftBumper", "BumperLeft"),
              ("CenterBumper", "BumperCenter"),
              ("RightBumper", "BumperRight"),
              ("LeftCliff", "CliffLeft"),
              ("CenterCliff", "CliffCenter"),
              ("RightCliff", "CliffRight"),
              ("LeftWheel", "WheelLeft"),
              ("RightWheel", "WheelRight"),
              ("Button0", "ButtonZero"),
              ("Button1", "ButtonOne"),
              ("Button2", "ButtonTwo")
            ]
      ]
    parts =
      [ (value, trWith "Its type is called {type}." ["type" =: t])
        | (values, t) <-
            [ (["Pressed", "Released"], "ButtonStatus"),
              (["Hole", "Floor"], "CliffStatus"),
              (["Air", "Ground"], "WheelStatus"),
              (["Online", "Offline"], "RobotStatus"),
              (["Black", "Green", "Orange", "Red"], "LedColor"),
              (["OnSound", "OffSound", "RechargeSound", "ButtonSound", "ErrorSound", "CleaningStartSound", "CleaningEndSound"], "Sound")
            ],
          value <- values
      ]

-- | A complete example of a type constructor.
exampleOf :: Text -> Text
exampleOf t = fromMaybe (t <> " Double") (lookup t [("Memory", "Memory Bool"), ("Param", "Param Int"), ("Task", "Task ()"), ("Done", "Done ()"), ("Maybe", "Maybe Sound"), ("Either", "Either Bumper Cliff")])

-- | The Rosy equivalent of a name from other languages.
foreignNameHint :: Text -> Maybe Sentence
foreignNameHint n
  | Just here <- originalNameHint n = Just here
  | Just phrase <- lookup n phrases = Just phrase
  | Just ours <- lookup n operators = Just (trWith "In Haskell this is written {code}." ["code" =: ours])
  | n `elem` ["Blue", "Yellow", "White", "Purple", "Pink", "Off"] = Just (tr "A light can be Black, which is off, Green, Orange or Red.")
  | Just ours <- haskellSpelling n = Just (trWith "In Haskell this is written {code}." ["code" =: ours])
  | n `elem` loopWords = Just (tr "Functions fire again and again by themselves; to repeat a task, write forever or replicateM_ 4.")
  | n == "Main" = Just (tr "A program starts at main, with a small letter.")
  | n `elem` ["O", "o"] = Just (tr "If the number is meant, write 0.")
  | n `elem` ["true", "false", "TRUE", "FALSE"] = Just (tr "Write True or False.")
  | n `elem` ["null", "None", "nil", "nothing"] = Just (tr "If there is nothing to give, write Nothing.")
  | otherwise = Nothing
  where
    operators = [("!=", "/="), ("<>=", ">="), ("=<", "<="), ("=>", ">="), ("===", "=="), ("&", "&&"), ("and", "&&"), ("or", "||"), ("elif", "else if"), ("elseif", "else if")]
    phrases =
      [ ("%", tr "In Haskell this is written with the word mod."),
        ("//", tr "In Haskell this is written with the word div."),
        ("+=", tr "In Haskell this is written with a new value: Memory (n + 1)."),
        ("-=", tr "In Haskell this is written with a new value: Memory (n - 1)."),
        ("++=", tr "In Haskell this is written with a new value."),
        ("print", tr "In Haskell this is written with Say.")
      ]

-- | Replacement of a unit behind a number.
unitHint :: Text -> Maybe Sentence
unitHint n
  | n `elem` ["degrees", "degree", "deg"] = Just (tr "Write: degreesToRadians 90, or degreesToOrientation 90.")
  | n `elem` ["cm", "centimeters", "centimetres"] = Just (tr "Lengths are in metres: write centimetersToMeters 50, or 0.5.")
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
  | "Task" `Text.isPrefixOf` t = tr "To give a name to a value in a task, write: let x = 3."
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
  | given == "Orientation" = tr "Take the number out with a pattern: (Orientation r)."
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
    isCommand t = t `elem` ["Velocity", "Led1", "Led2", "Sound", "Say"]
