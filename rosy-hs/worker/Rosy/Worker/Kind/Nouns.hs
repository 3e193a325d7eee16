{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind.Nouns
-- Description : What robot programs are about, for hints: how values of Rosy's types are written, and what names from elsewhere mean here.
module Rosy.Worker.Kind.Nouns
  ( writtenAs,
    wrapperOf,
    typeOfValue,
    exampleOf,
    foreignName,
    unitOf,
    spelling,
    loops,

    -- * What to do about it
    isNumber,
    convert,
    numberHint,
    mixedHint,
  )
where

import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Kind.Words (Type)

-- | How a value of the type is written.
writtenAs :: Text -> Maybe Text
writtenAs t = lookup t table
  where
    table =
      [ ("BumperSide", "It is LeftBumper, CenterBumper or RightBumper."),
        ("CliffSide", "It is LeftCliff, CenterCliff or RightCliff."),
        ("WheelSide", "It is LeftWheel or RightWheel."),
        ("ButtonNumber", "It is Button0, Button1 or Button2."),
        ("ButtonStatus", "It is Pressed or Released."),
        ("CliffStatus", "It is Hole or Floor."),
        ("WheelStatus", "It is Air or Ground."),
        ("RobotStatus", "It is Online or Offline."),
        ("LedColor", "It is Black, Green, Orange or Red."),
        ("Sound", "It is a sound such as ErrorSound or ButtonSound."),
        ("Bumper", "Write it with both its parts, for example: (Bumper LeftBumper Pressed)."),
        ("Cliff", "Write it with both its parts, for example: (Cliff LeftCliff Hole)."),
        ("Wheel", "Write it with both its parts, for example: (Wheel LeftWheel Air)."),
        ("Button", "Write it with both its parts, for example: (Button Button0 Pressed)."),
        ("Velocity", "Write it with both its parts, for example: (Velocity 0.5 0)."),
        ("Clock", "Take it apart with a pattern: (Clock h m s ms)."),
        ("Position", "Write it with both its parts, for example: (Position x y).")
      ]

-- | What turns the first type into the second: a constructor.
wrapperOf :: Text -> Text -> Maybe Text
wrapperOf given needed
  | given == "LedColor", needed `elem` ["Led1", "Led2"] = Just needed
  | given == "String", needed == "Say" = Just "Say"
  | otherwise = Nothing

-- | The type to write where a value was written.
typeOfValue :: Text -> Maybe Text
typeOfValue v = lookup v (sides ++ parts)
  where
    sides =
      [ (value, "To sense only this one, write " <> t <> ".")
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
      [ (value, "Its type is called " <> t <> ".")
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

-- | A type that needs another beside it, complete.
exampleOf :: Text -> Text
exampleOf t = fromMaybe (t <> " Double") (lookup t [("Memory", "Memory Bool"), ("Param", "Param Int"), ("Task", "Task ()"), ("Done", "Done ()"), ("Maybe", "Maybe Sound"), ("Either", "Either Bumper Cliff")])

-- | What is meant by a name that other languages have, or that the robot has not.
foreignName :: Text -> Maybe Text
foreignName n
  | Just ours <- lookup n operators = Just ("In Haskell this is written " <> ours <> ".")
  | n `elem` ["Blue", "Yellow", "White", "Purple", "Pink", "Off"] = Just "A light can be Black, which is off, Green, Orange or Red."
  | Just ours <- spelling n = Just ("In Haskell this is written " <> ours <> ".")
  | n `elem` loops = Just "Functions fire again and again by themselves; to repeat a task, write forever or replicateM_ 4."
  | n == "Main" = Just "A program starts at main, with a small letter."
  | n `elem` ["O", "o"] = Just "If the number is meant, write 0."
  | n `elem` ["true", "false", "TRUE", "FALSE"] = Just "Write True or False."
  | n `elem` ["null", "None", "nil", "nothing"] = Just "If there is nothing to give, write Nothing."
  | otherwise = Nothing
  where
    operators = [("!=", "/="), ("<>=", ">="), ("=<", "<="), ("=>", ">="), ("===", "=="), ("&", "&&"), ("and", "&&"), ("or", "||"), ("%", "with the word mod"), ("//", "with the word div"), ("+=", "with a new value: Memory (n + 1)"), ("-=", "with a new value: Memory (n - 1)"), ("++=", "with a new value"), ("elif", "else if"), ("elseif", "else if"), ("print", "with Say")]

-- | What to write instead of a unit behind a number.
unitOf :: Text -> Maybe Text
unitOf n
  | n `elem` ["degrees", "degree", "deg"] = Just "Write: degreesToRadians 90, or degreesToOrientation 90."
  | n `elem` ["cm", "centimeters", "centimetres"] = Just "Lengths are in metres: write centimetersToMeters 50, or 0.5."
  | n `elem` ["ms", "milliseconds"] = Just "Times are in seconds: write 0.5 for half a second."
  | n `elem` ["s", "sec", "secs", "second", "seconds", "m", "meters", "metres", "rad", "radians"] = Just ("Remove ‘" <> n <> "’: times are in seconds, lengths in metres, angles in radians.")
  | otherwise = Nothing

-- | How a name of other languages is spelled here.
spelling :: Text -> Maybe Text
spelling n = lookup n [("Number", "Double"), ("Num", "Double"), ("Boolean", "Bool"), ("Str", "String"), ("Text", "String"), ("PI", "pi"), ("Pi", "pi"), ("Void", "()")]

-- | What other languages call their loops.
loops :: [Text]
loops = ["for", "while", "loop"]

-- | What to do when a number stands where this is needed.
numberHint :: Type -> Text
numberHint t
  | "Task" `Text.isPrefixOf` t = "To give a name to a value in a task, write: let x = 3."
  | t == "Bool" = "Write True or False."
  | t == "String" = "Put it in quotation marks, or turn it into a text with show."
  | otherwise = fromMaybe "Check which value belongs here." (writtenAs t)

-- | Whether it is one of the types of numbers.
isNumber :: Type -> Bool
isNumber t = t `elem` ["Int", "Integer", "Double", "Float", "Seconds", "Orientation", "Word", "Rational", "Degrees", "Radians", "Centimeters", "Meters"]

-- | How one number becomes another: what is needed, what is there.
convert :: Type -> Type -> Text
convert needed given
  | whole' given, whole' needed = "Convert it with fromIntegral."
  | whole' given = "Convert it with fromIntegral."
  | whole' needed = "Round it with round."
  | needed == "Seconds" = "Convert it with doubleToSeconds."
  | given == "Seconds" = "Convert it with secondsToDouble."
  | given == "Orientation" = "Take the number out with a pattern: (Orientation r)."
  | needed == "Orientation" = "Write Orientation in front of it."
  | otherwise = "Convert it with realToFrac."
  where
    whole' t = t `elem` ["Int", "Integer", "Word"]

-- | What to do when one thing stands where another is needed.
mixedHint :: Type -> Type -> Text
mixedHint needed given
  | all isCommand [needed, given] = "A function gives one type of command: use Either, Maybe or a pair for several."
  | otherwise = fromMaybe "Check which of the two was meant." (writtenAs needed)
  where
    isCommand t = t `elem` ["Velocity", "Led1", "Led2", "Sound", "Say"]
