-- |
-- Module      : Rosy.Worker.Explanation.TextualMistakes
-- Description : Typical mistakes of learners, found in the text of a rejected program.
--
-- The compiler often reports such a mistake elsewhere, or as another one: @.5@ is a composition of functions for it, @Cruise ()@ a constructor.
-- The rules are tried only on a program that the compiler rejects. "Rosy.Worker.Explanation" then leaves out what the compiler says about the
-- same place. Pure.
module Rosy.Worker.Explanation.TextualMistakes
  ( textualMistakes,
  )
where

import Rosy.Worker.Explanation.TextRepair (Program)
import Rosy.Worker.Explanation.TextualMistakes.Conditions
import Rosy.Worker.Explanation.TextualMistakes.CopiedText
import Rosy.Worker.Explanation.TextualMistakes.Definitions
import Rosy.Worker.Explanation.TextualMistakes.Names
import Rosy.Worker.Explanation.TextualMistakes.Numbers
import Rosy.Worker.Explanation.TextualMistakes.Tasks
import Rosy.Worker.Explanation.TextualMistakes.Texts
import Rosy.Worker.Problem

-- | What the rules find, in their order; of mistakes at overlapping places the first. A learner mends no more than twenty at a time.
textualMistakes :: Program -> [Problem]
textualMistakes p = foldl keep [] (take 20 (concatMap ($ p) rules))
  where
    keep found new = if any (overlaps new) found then found else found ++ [new]
    overlaps a b = or [start s < end t && start t < end s | Just s <- [place a], Just t <- [place b]]

rules :: [Program -> [Problem]]
rules =
  [ copiedLines,
    comments,
    numberedSteps,
    units,
    numbers,
    quotes,
    braces,
    capitals,
    smallLetters,
    namesInParts,
    definitions,
    declarations,
    guards,
    lastCases,
    patterns,
    conditions,
    lambdas,
    tasks,
    texts,
    programStart,
    secondValues
  ]
