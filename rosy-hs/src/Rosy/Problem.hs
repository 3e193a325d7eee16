{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Rosy.Problem
-- Description : What can go wrong while a program runs, and the sentence for it.
--
-- Every way to end badly is a constructor of 'Fault'; what the learner's own code throws comes from Haskell's
-- exceptions. 'problemFrom' is the one total function that turns either into what the learner reads.
-- The fields are those of protocol/README.md section 1; places in the text are added by those who know the text.
module Rosy.Problem
  ( -- * What can go wrong
    Fault (..),

    -- * What the learner reads
    Problem (..),
    problemFrom,
    tooMuchMemory,

    -- * Empty places
    EmptyPlace,
    atEmptyPlace,
  )
where

import Control.Exception
import Data.Char (isDigit)
import Data.List (isPrefixOf, sortOn)
import Data.Maybe (fromMaybe)
import System.IO.Unsafe (unsafePerformIO)

-- | A failure that Rosy itself finds.
data Fault
  = -- | A command carries a number that is none, or is endless. Carries what it was to be.
    NotANumber String
  | -- | A 'Rosy.Done' of another type than its task's; carries both types.
    WrongDone String String
  | -- | A 'Rosy.call' in 'Rosy.once', which does not last: what it calls would be stopped at once.
    CallInOnce
  | -- | A memory of a type without a finite default was read before it was written; carries the type.
    NoDefault String
  | -- | A message of a topic of the program's own lacks a field, or has another type in it; carries the topic and the field.
    Unreadable String String
  | -- | The robot is gone.
    LinkLost String
  | -- | The other side said something that protocol/README.md does not have; carries the line.
    Malformed String
  | -- | 'Rosy.simulate' was called although the program had run before.
    RanBefore
  deriving (Eq, Show)

instance Exception Fault

-- | A problem at run time.
data Problem = Problem
  { problemKind :: String,
    problemFunction :: Maybe String,
    problemMessage :: String,
    problemHint :: String,
    -- | What Haskell said; may be empty.
    problemOriginal :: String,
    problemTime :: Maybe Double,
    problemInputs :: [String],
    -- | Start and end in the text, as line and column from 1; known of an empty place only.
    problemPlace :: Maybe ((Int, Int), (Int, Int))
  }
  deriving (Eq, Show)

-- | The problem that an exception is. Takes the function at work, what it was given, and the time.
problemFrom :: Maybe String -> [String] -> Maybe Double -> SomeException -> Problem
problemFrom function inputs time exception =
  Problem
    { problemKind = kind,
      problemFunction = function,
      problemMessage = message,
      problemHint = hint,
      problemOriginal = takeWhile (/= '\0') (readable (displayException exception)),
      problemTime = time,
      problemInputs = inputs,
      problemPlace = Nothing
    }
  where
    (kind, message, hint) = sentence (named function) exception

-- | How sentences call a function, or whatever it was when no function was at work.
named :: Maybe String -> String
named = fromMaybe "The program"

-- | Kind, message and hint.
sentence :: String -> SomeException -> (String, String, String)
sentence who exception
  | Just fault <- fromException exception = faultSentence who fault
  | Just (PatternMatchFail _) <- fromException exception =
    ("exception", who ++ " has no case for what it was given.", "Add a case for it, or one that starts with _.")
  | Just arithmetic <- fromException exception = case arithmetic of
    DivideByZero -> ("exception", who ++ " divided by zero.", "Check the number before dividing.")
    other -> ("exception", who ++ " computed a number that does not exist.", show other ++ ".")
  | Just async <- fromException exception = case async of
    StackOverflow -> ("memory", memoryMessage who, "It may call itself without end.")
    HeapOverflow -> ("memory", memoryMessage who, endless)
    _ -> ("stopped", "The program was stopped.", "")
  | Just NonTermination <- fromException exception =
    ("exception", who ++ " waits for its own answer.", "It may use a value to compute that same value.")
  | Just (RecSelError _) <- fromException exception = ("exception", who ++ " asked for a field that this value does not have.", "Look at it with a pattern first: not every constructor has every field.")
  | Just (NoMethodError _) <- fromException exception = ("exception", who ++ " used a function that an instance leaves out.", "Define it in the instance.")
  | Just (TypeError _) <- fromException exception = ("hole", who ++ " came to an empty place.", "Put a value in it.")
  | Just (RecConError _) <- fromException exception = ("exception", who ++ " used a field that was never given a value.", "Give it one where the value is made.")
  | Just (ErrorCall text) <- fromException exception = errorSentence who (readable text)
  | otherwise = ("exception", who ++ " failed.", firstLine (readable (displayException exception)))

-- | An empty place of a program, @_@ or @_name@: where it starts and ends, as line and column from 1, and the message and hint of a run that comes to it.
type EmptyPlace = ((Int, Int), (Int, Int), String, String)

-- | The problem of a run that came to one of these places; other problems stay as they are. GHC says where the expression starts that it could not
-- give a meaning: the place itself, or an expression around it whose types depend on it.
atEmptyPlace :: [EmptyPlace] -> Problem -> Problem
atEmptyPlace places problem = case (problemKind problem, positionIn (problemOriginal problem)) of
  ("hole", Just at) | (from, to, message, hint) : _ <- [place | place@(from, _, _, _) <- ordered, from >= at] ++ reverse ordered -> problem {problemMessage = message, problemHint = hint, problemPlace = Just (from, to)}
  _ -> problem
  where
    ordered = sortOn (\(from, _, _, _) -> from) places

-- | The line and column at the start of a message of GHC: of @Main.hs:4:17-22: error@, or @Main.hs:(4,17)-(5,3): error@.
positionIn :: String -> Maybe (Int, Int)
positionIn message = case span isDigit (dropWhile (== '(') (drop 1 (dropWhile (/= ':') message))) of
  (l@(_ : _), separator : rest) | separator `elem` ":,", c@(_ : _) <- takeWhile isDigit rest -> Just (read l, read c)
  _ -> Nothing

-- | Message and hint for a program that has no memory left to say them itself. Takes the function at work.
tooMuchMemory :: Maybe String -> (String, String)
tooMuchMemory function = (memoryMessage (named function), endless)

memoryMessage :: String -> String
memoryMessage who = who ++ " needed too much memory."

endless :: String
endless = "It may build something without end."

errorSentence :: String -> String -> (String, String, String)
errorSentence who text
  | "Prelude." `isPrefixOf` text && "empty list" `elem'` text =
    ("exception", who ++ " took something out of an empty list.", "Check that the list has something in it first.")
  | "Prelude.undefined" `isPrefixOf` text =
    ("exception", who ++ " reached undefined.", "Put a value in its place.")
  | "Prelude.read" `isPrefixOf` text =
    ("exception", who ++ " could not read a text as a value.", "Check how the text is written.")
  | "Prelude.!!" `isPrefixOf` text =
    ("exception", who ++ " looked for something past the end of a list.", "A list of n things has the places 0 to n - 1.")
  | "Maybe.fromJust" `isPrefixOf` text =
    ("exception", who ++ " took something out of a Nothing.", "Use a pattern, or fromMaybe with a value for that case.")
  | any (`isPrefixOf` text) ["Map.!", "IntMap.!"] =
    ("exception", who ++ " looked for a key that is not in the map.", "Use Map.lookup: it gives Nothing when there is none.")
  | any (`elem'` text) ["bad argument", "tried to take `"] =
    ("exception", who ++ " counted past the last value of a type.", "Check first that there is a next one.")
  | "Negative exponent" `isPrefixOf` text =
    ("exception", who ++ " raised a number to a negative power with ^.", "Use ** for that.")
  | otherwise = ("exception", who ++ " stopped with an error: " ++ firstLine text, "")
  where
    needle `elem'` hay = any (needle `isPrefixOf`) (suffixes hay)
    suffixes [] = []
    suffixes s@(_ : rest) = s : suffixes rest

faultSentence :: String -> Fault -> (String, String, String)
faultSentence who = \case
  NotANumber what -> ("not-a-number", who ++ " gave a " ++ what ++ " that is not a number.", "It may have divided by zero.")
  WrongDone given wanted ->
    ("wrong-done", who ++ " ended the task with a value of type " ++ given ++ ".", "This task ends with " ++ wanted ++ ".")
  CallInOnce -> ("call-in-once", who ++ " started a task in once, which does not wait for it.", "Write the task itself in place of once, or put it beside others with parallel.")
  NoDefault what ->
    ( "no-default",
      who ++ " reads a memory of " ++ what ++ ", which has no first value.",
      "Every way to make a " ++ what ++ " needs another one. Add a constructor that does not."
    )
  Unreadable name path ->
    ( "unreadable-message",
      who ++ " was sent a message of " ++ name ++ " in which " ++ path ++ " is missing or of another kind.",
      "Compare the name and the type of this field with what is sent."
    )
  LinkLost _ -> ("link-lost", "The connection to the robot was lost.", "Check that the robot is on, then run the program again.")
  Malformed line -> ("malformed", "The robot said something that Rosy does not understand.", take 200 line)
  RanBefore -> ("ran-before", "The program called simulate a second time.", "A program runs one robot once; put both controllers in one list.")

-- | The start of a message. The message is a learner's own text: it may have no end, and may fail in its turn.
readable :: String -> String
readable = unsafePerformIO . upTo longestMessage
  where
    upTo :: Int -> String -> IO String
    upTo n text
      | n <= 0 = pure ""
      | otherwise = do
        next <- try (evaluate (case text of [] -> Nothing; c : rest -> c `seq` Just (c, rest)))
        case next of
          Right (Just (c, rest)) -> (c :) <$> upTo (n - 1) rest
          Right Nothing -> pure ""
          Left (SomeException _) -> pure "..."

-- | Characters of a message that are kept.
longestMessage :: Int
longestMessage = 2000

firstLine :: String -> String
firstLine = takeWhile (/= '\n') . take 300
