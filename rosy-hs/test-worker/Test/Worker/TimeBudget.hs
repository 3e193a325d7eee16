-- |
-- Module      : Test.Worker.TimeBudget
-- Description : Tests of the time that a child may work, on fast and slow computers.
module Test.Worker.TimeBudget (tests) where

import Rosy.Worker.TimeBudget
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "Time budget"
    [ testCase "a child that has the processor to itself ends after its seconds" $ endOf 1 0 @?= 10,
      testCase "one that gets a third of the processor has three times as long" $ endOf (1 / 3) 0 @?= 30,
      testCase "one that waits ends all the same" $ endOf 0 0 @?= 50,
      testCase "what it has computed for earlier answers does not count" $ endOf 1 100 @?= 10,
      testCase "it is looked at again when it can have used up its seconds at the earliest" $
        (nextReview <$> review 10 4 (newBudget 10 0 0)) @?= Just 16,
      testCase "and not all the time shortly before that" $
        (nextReview <$> review 10 9.999 (newBudget 10 0 0)) @?= Just 10.05
    ]

-- | After how many seconds a child ends that may compute for ten, has this share of a processor, and has computed for so long before;
-- to whole seconds.
endOf :: Double -> Double -> Int
endOf share before = go (newBudget 10 0 before)
  where
    go budget = let now = nextReview budget in maybe (round now) go (review now (before + share * now) budget)
