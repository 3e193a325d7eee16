{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# OPTIONS_GHC -Wno-incomplete-patterns -Wno-missing-methods -Wno-missing-fields -Wno-partial-fields #-}

-- |
-- Module      : Test.Rosy.Problem
-- Description : What a learner reads when something is thrown, and whom it names.
module Test.Rosy.Problem (tests) where

import Control.Exception (ErrorCall (..), Exception, SomeException, TypeError (..), evaluate, throw, toException, try)
import qualified Data.Map as Map
import Data.Maybe (fromJust, isJust)
import qualified Data.Text as Text
import Rosy
import Rosy.Problem
import Rosy.Program (Names (..), within)
import Rosy.Runnable (program)
import Rosy.Sentence (english, sentenceId)
import Support.Rehearsal
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit

data Shape = Square {side :: Int} | Point deriving (Show)

class Tells a where tell :: a -> Int

instance Tells Shape

-- | An exception whose text may be empty.
newtype Silent = Silent String

instance Show Silent where show (Silent said) = said

instance Exception Silent

{- HLINT ignore "Evaluate" -}

tests :: TestTree
tests =
  testGroup
    "Problem"
    [ testGroup
        "says kindly"
        [ says "an empty list" (head []) "f took something out of an empty list.",
          says "a division by zero" (1 `div` 0) "f divided by zero.",
          says "a missing case" (case words "x" of [] -> 1) "f has no case for what it was given.",
          says "undefined" undefined "f reached undefined.",
          says "the program's own error" (error "too fast") "f stopped with an error: too fast",
          says "a Nothing" (fromJust Nothing) "f took something out of a Nothing.",
          says "a missing key" (Map.fromList [(1 :: Int, 1)] Map.! 2) "f looked for a key that is not in the map.",
          says "a text that is no number" (read "x") "f could not read a text as a value.",
          says "a place past the end" ([1] !! 5) "f looked for something past the end of a list.",
          says "the last of its type" (fromEnum (succ True)) "f counted past the last value of a type.",
          says "a negative power" (2 ^ negate (1 :: Int)) "f raised a number to a negative power with ^.",
          says "a field of another constructor" (side Point) "f asked for a field that this value does not have.",
          says "a field without a value" (side Square {}) "f used a field that was never given a value.",
          says "a function that an instance leaves out" (tell Point) "f used a function that an instance leaves out.",
          says "a memory of a type without a finite default" (throw (NoDefault "Loop")) "f reads a memory of Loop, which has no first value.",
          says "a message without end" (error (cycle "no ")) ("f stopped with an error: " ++ take 300 (cycle "no ")),
          says "a message that fails in its turn" (let message = 'a' : error message in error message) "f stopped with an error: a..."
        ],
      testCase "an exception without a text, or with blank lines first, says what is known of it" $ do
        let told e = let p = problemFrom (Just "main") [] Nothing e in (english (problemMessage p), english (problemHint p))
        told (toException (Silent "")) @?= ("main failed.", "It stopped with Silent, an exception without a text.")
        told (toException (Silent "\n \t")) @?= ("main failed.", "It stopped with Silent, an exception without a text.")
        told (toException (Silent "\n\n  too fast\nmore")) @?= ("main failed.", "too fast")
        told (toException (userError "too fast")) @?= ("main failed.", "user error (too fast)")
        told (toException (ErrorCall "")) @?= ("main called error with an empty text.", "Say in the text what went wrong.")
        told (toException (ErrorCall "\ntoo fast")) @?= ("main stopped with an error: too fast", ""),
      testCase "a run that comes to an empty place names the one at the position of GHC's message, or the next one inside of the expression" $ do
        let places = [((1, 25), (1, 26), "second", "b"), ((1, 17), (1, 22), "first", "a"), ((4, 3), (4, 4), "third", "c")]
            at said = let p = atEmptyPlace places (problemFrom (Just "f") [] Nothing (toException (TypeError said))) in (problemKind p, english (problemMessage p), english (problemHint p), problemPlace p)
        at "Main.hs:1:25: error:" @?= ("hole", "second", "b", Just ((1, 25), (1, 26)))
        at "Main.hs:1:17-21: error:" @?= ("hole", "first", "a", Just ((1, 17), (1, 22)))
        at "Main.hs:1:8-26: error:" @?= ("hole", "first", "a", Just ((1, 17), (1, 22)))
        at "Main.hs:(2,1)-(4,4): error:" @?= ("hole", "third", "c", Just ((4, 3), (4, 4)))
        at "Main.hs:9:1: error:" @?= ("hole", "third", "c", Just ((4, 3), (4, 4)))
        at "nowhere" @?= ("hole", "f came to an empty place.", "Put a value in it.", Nothing)
        english (problemMessage (atEmptyPlace places (problemFrom (Just "f") [] Nothing (toException (ErrorCall "Main.hs:1:17: x"))))) @?= "f stopped with an error: Main.hs:1:17: x",
      testCase "a task that cannot be computed is blamed on its definition, and live tasks clean up" $ do
        heard <- rehearse [Steps 0 [] True] (program (Names []) (parallel guarded (within "plan" (const broken))))
        (concatMap heardCommands heard, heardEnd (last heard))
          @?= (["Led1 Green", "Say \"a\"", "Led1 Red", "Velocity 0.0 0.0"], Just (End "error" (Just "exception") (Just "plan")))
    ]
  where
    guarded, broken :: Task ()
    guarded = taskWith TaskOptions {starting = Led1 Green, stopped = Led1 Red} (\Never -> Done ())
    broken = say "a" >> within "plan" (\_ -> if head [] then pure () else say "b")
    says what (value :: Int) wanted = testCase what $ do
      thrown <- try (evaluate value)
      case thrown of
        Right _ -> assertFailure "nothing was thrown"
        Left (e :: SomeException) -> do
          let problem = problemFrom (Just "f") [] Nothing e
          english (problemMessage problem) @?= Text.pack wanted
          assertBool (Text.unpack (english (problemHint problem))) (not ("Prelude" `Text.isInfixOf` english (problemHint problem)))
          -- Every message has a translation; the learner's own text is an argument of it.
          assertBool "it has no id" (isJust (sentenceId (problemMessage problem)))
