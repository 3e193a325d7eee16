-- |
-- Module      : Test.Rosy.Model
-- Description : The runtime means what the model says, on generated programs and happenings.
--
-- A program of the model and its translation ("Support.Translated") are given the same happenings, and must say the same at the same times. What the program says is read from the lines that a link would carry, after
-- "Rosy.Run" has driven it: failures, zero velocity at the end and whom a problem names are part of it.
module Test.Rosy.Model (tests) where

import Data.List (isPrefixOf)
import Rosy.Model hiding (tasks)
import qualified Rosy.Robot as R
import Support.Generated
import Support.Rehearsal
import Support.Translated
import Test.QuickCheck hiding (Function, function, label)
import Test.Tasty (TestTree, adjustOption, localOption, testGroup)
import Test.Tasty.QuickCheck (QuickCheckTests (..), testProperty)

tests :: TestTree
tests =
  adjustOption (max (QuickCheckTests 500)) . testGroup "Model: the runtime means what the model says" $
    [ testProperty "for controllers" (forAllShrink controllers (const []) (\(Shown _ p) -> agree p)),
      testProperty "for tasks" (forAllShrink tasks (const []) (\(Shown _ p) -> agree p)),
      testProperty "for tasks that fail, are stopped or lose their robot" (forAllShrink fragile (const []) (\(Shown _ p) (Days days) -> ending days (agreeOn p))),
      localOption (QuickCheckTests 10) $
        testProperty "for functions that feed each other for ever" (\(Days days) -> agreeOn endless (take 6 days))
    ]
  where
    agree p (Days days) = agreeOn p days
    -- Two in three of these runs are ended from outside, wherever they are.
    ending days run = forAll (choose (0, length days)) $ \at ->
      forAll (elements [[], [Stop], [Stop], [Loss]]) $ \last' ->
        let (before, after) = splitAt at days in run (before ++ [(if null before then 0 else fst (last before), h) | h <- last'] ++ after)

-- | Both say the same.
agreeOn :: Program -> [(Int, Happening)] -> Property
agreeOn p days =
  cover 40 (length said > 2) "programs that say something" . classify (or [True | (_, Fired "stopped") <- said]) "with a clean-up" . tabulate "ends" [takeWhile (/= ' ') (show e) | (_, Over e) <- said] $
    ioProperty (counterexample "the runtime, then the model:" . (=== said) <$> runtime p days)
  where
    said = meaning p days

-- | What the runtime says of the program.
runtime :: Program -> [(Int, Happening)] -> IO [(Int, Said)]
runtime p days = concatMap sayings <$> rehearse (cues days) (translated p)
  where
    sayings h = [(round (heardAt h * 1000), s) | s <- map read' (heardCommands h) ++ maybe [] ended (heardEnd h)]
    -- Firings and commands come as one list: the translation says each firing aloud.
    read' line
      | "Velocity" `isPrefixOf` line, R.Velocity v _ <- read line = Driven (round v)
      | "Led1" `isPrefixOf` line, R.Led1 color <- read line = Lit (fromEnum color)
      | otherwise = case read line of
        R.Say ('!' : who) -> Fired who
        R.Say text -> Commanded (read text)
    ended e = case e of
      Broken -> [Over Lost]
      End "done" Nothing Nothing -> [Over Finished]
      End "stopped" Nothing Nothing -> [Over Stopped]
      End "error" (Just "wrong-done") (Just who) -> [Over (EndedWrongly who)]
      End "error" (Just "call-in-once") (Just who) -> [Over (CalledInOnce who)]
      End "error" (Just "exception") (Just who) -> [Over (Failed who)]
      other -> error (show other)
