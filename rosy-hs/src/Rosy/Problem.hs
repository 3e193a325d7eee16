{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

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
import Data.Char (isDigit, isSpace)
import Data.List (isPrefixOf, sortOn)
import qualified Data.Text as Text
import Data.Typeable (typeOf)
import Rosy.Sentence
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
    problemMessage :: Sentence,
    problemHint :: Sentence,
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
      problemOriginal = takeWhile (/= '\0') (readable (exceptionMessage exception)),
      problemTime = time,
      problemInputs = inputs,
      problemPlace = Nothing
    }
  where
    (kind, message, hint) = sentence (named function) exception

-- | The message of an exception. From GHC 9.10 on 'displayException' of 'SomeException' adds a backtrace through GHC's own libraries.
exceptionMessage :: SomeException -> String
exceptionMessage (SomeException exception) = displayException exception

-- | How sentences call a function, or the program when no function was at work.
named :: Maybe String -> Sentence
named = maybe (tr "The program") quoted

-- | Kind, message and hint.
sentence :: Sentence -> SomeException -> (String, Sentence, Sentence)
sentence who exception
  | Just fault <- fromException exception = faultSentence who fault
  | Just (PatternMatchFail _) <- fromException exception =
    ("exception", trWith "{who} has no case for what it was given." ["who" =@ who], tr "Add a case for it, or one that starts with _.")
  | Just arithmetic <- fromException exception = case arithmetic of
    DivideByZero -> ("exception", trWith "{who} divided by zero." ["who" =@ who], tr "Check the number before dividing.")
    other -> ("exception", trWith "{who} computed a number that does not exist." ["who" =@ who], quoted (show other ++ "."))
  | Just async <- fromException exception = case async of
    StackOverflow -> ("memory", memoryMessage who, tr "It may call itself without end.")
    HeapOverflow -> ("memory", memoryMessage who, endless)
    _ -> ("stopped", tr "The program was stopped.", verbatim "")
  | Just NonTermination <- fromException exception =
    ("exception", trWith "{who} waits for its own answer." ["who" =@ who], tr "It may use a value to compute that same value.")
  | Just (RecSelError _) <- fromException exception = ("exception", trWith "{who} asked for a field that this value does not have." ["who" =@ who], tr "Look at it with a pattern first: not every constructor has every field.")
  | Just (NoMethodError _) <- fromException exception = ("exception", trWith "{who} used a function that an instance leaves out." ["who" =@ who], tr "Define it in the instance.")
  | Just (TypeError _) <- fromException exception = ("hole", trWith "{who} came to an empty place." ["who" =@ who], tr "Put a value in it.")
  | Just (RecConError _) <- fromException exception = ("exception", trWith "{who} used a field that was never given a value." ["who" =@ who], tr "Give it one where the value is made.")
  | Just (ErrorCall text) <- fromException exception = errorSentence who (readable text)
  | text <- firstLine (readable (exceptionMessage exception)), not (null text) = ("exception", trWith "{who} failed." ["who" =@ who], quoted text)
  | otherwise = ("exception", trWith "{who} failed." ["who" =@ who], trWith "It stopped with {exception}, an exception without a text." ["exception" =: typeName exception])

typeName :: SomeException -> Text.Text
typeName (SomeException exception) = Text.pack (show (typeOf exception))

-- | The words of Haskell, or of the program.
quoted :: String -> Sentence
quoted = verbatim . Text.pack

-- | An empty place of a program, @_@ or @_name@: where it starts and ends, as line and column from 1, and the message and hint of a run that comes to it,
-- each as a 'portable' sentence: the worker's copy of this module and the library's exchange them.
type EmptyPlace = ((Int, Int), (Int, Int), String, String)

-- | The problem of a run that came to one of these places; other problems stay as they are. GHC says where the expression starts that it could not
-- give a meaning: the place itself, or an expression around it whose types depend on it.
atEmptyPlace :: [EmptyPlace] -> Problem -> Problem
atEmptyPlace places problem = case (problemKind problem, positionIn (problemOriginal problem)) of
  ("hole", Just at) | (from, to, message, hint) : _ <- [place | place@(from, _, _, _) <- ordered, from >= at] ++ reverse ordered -> problem {problemMessage = fromPortable message, problemHint = fromPortable hint, problemPlace = Just (from, to)}
  _ -> problem
  where
    ordered = sortOn (\(from, _, _, _) -> from) places

-- | The line and column at the start of a message of GHC: of @Main.hs:4:17-22: error@, or @Main.hs:(4,17)-(5,3): error@.
positionIn :: String -> Maybe (Int, Int)
positionIn message = case span isDigit (dropWhile (== '(') (drop 1 (dropWhile (/= ':') message))) of
  (l@(_ : _), separator : rest) | separator `elem` (":," :: String), c@(_ : _) <- takeWhile isDigit rest -> Just (read l, read c)
  _ -> Nothing

-- | Message and hint for a program that has no memory left to say them itself. Takes the function at work.
tooMuchMemory :: Maybe String -> (Sentence, Sentence)
tooMuchMemory function = (memoryMessage (named function), endless)

memoryMessage :: Sentence -> Sentence
memoryMessage who = trWith "{who} needed too much memory." ["who" =@ who]

endless :: Sentence
endless = tr "It may build something without end."

errorSentence :: Sentence -> String -> (String, Sentence, Sentence)
errorSentence who text
  | "Prelude." `isPrefixOf` text && "empty list" `elem'` text =
    ("exception", trWith "{who} took something out of an empty list." ["who" =@ who], tr "Check that the list has something in it first.")
  | "Prelude.undefined" `isPrefixOf` text =
    ("exception", trWith "{who} reached undefined." ["who" =@ who], tr "Put a value in its place.")
  | "Prelude.read" `isPrefixOf` text =
    ("exception", trWith "{who} could not read a text as a value." ["who" =@ who], tr "Check how the text is written.")
  | "Prelude.!!" `isPrefixOf` text =
    ("exception", trWith "{who} looked for something past the end of a list." ["who" =@ who], tr "A list of n things has the places 0 to n - 1.")
  | "Maybe.fromJust" `isPrefixOf` text =
    ("exception", trWith "{who} took something out of a Nothing." ["who" =@ who], tr "Use a pattern, or fromMaybe with a value for that case.")
  | any (`isPrefixOf` text) ["Map.!", "IntMap.!"] =
    ("exception", trWith "{who} looked for a key that is not in the map." ["who" =@ who], tr "Use Map.lookup: it gives Nothing when there is none.")
  | any (`elem'` text) ["bad argument", "tried to take `"] =
    ("exception", trWith "{who} counted past the last value of a type." ["who" =@ who], tr "Check first that there is a next one.")
  | "Negative exponent" `isPrefixOf` text =
    ("exception", trWith "{who} raised a number to a negative power with ^." ["who" =@ who], tr "Use ** for that.")
  | null (firstLine text) = ("exception", trWith "{who} called error with an empty text." ["who" =@ who], tr "Say in the text what went wrong.")
  | otherwise = ("exception", trWith "{who} stopped with an error: {text}" ["who" =@ who, "text" =: Text.pack (firstLine text)], verbatim "")
  where
    needle `elem'` hay = any (needle `isPrefixOf`) (suffixes hay)
    suffixes [] = []
    suffixes s@(_ : rest) = s : suffixes rest

faultSentence :: Sentence -> Fault -> (String, Sentence, Sentence)
faultSentence who = \case
  NotANumber "speed" -> ("not-a-number", trWith "{who} gave a speed that is not a number." ["who" =@ who], divided)
  NotANumber _ -> ("not-a-number", trWith "{who} gave a value that is not a number." ["who" =@ who], divided)
  WrongDone given wanted ->
    ( "wrong-done",
      trWith "{who} ended the task with a value of type {given}." ["who" =@ who, "given" =: Text.pack given],
      trWith "This task ends with {wanted}." ["wanted" =: Text.pack wanted]
    )
  CallInOnce ->
    ( "call-in-once",
      trWith "{who} started a task in once, which does not wait for it." ["who" =@ who],
      tr "Write the task itself in place of once, or put it beside others with parallel."
    )
  NoDefault what ->
    ( "no-default",
      trWith "{who} reads a memory of {type}, which has no first value." ["who" =@ who, "type" =: Text.pack what],
      trWith "Every way to make a {type} needs another one. Add a constructor that does not." ["type" =: Text.pack what]
    )
  Unreadable name path ->
    ( "unreadable-message",
      trWith "{who} was sent a message of {topic} in which {field} is missing or of another kind." ["who" =@ who, "topic" =: Text.pack name, "field" =: Text.pack path],
      tr "Compare the name and the type of this field with what is sent."
    )
  LinkLost _ -> ("link-lost", tr "The connection to the robot was lost.", tr "Check that the robot is on, then run the program again.")
  Malformed line -> ("malformed", tr "The robot said something that Rosy does not understand.", quoted (take 200 line))
  RanBefore -> ("ran-before", tr "The program called simulate a second time.", tr "A program runs one robot once; put both controllers in one list.")
  where
    divided = tr "It may have divided by zero."

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

-- | The first line that is not blank; empty without one.
firstLine :: String -> String
firstLine = takeWhile (/= '\n') . take 300 . dropWhile isSpace
