-- |
-- Module      : Rosy.Worker.TimeBudget
-- Description : How long a child may work at one answer.
--
-- Counts the processor time that the child has used, so that a busy computer, which gives it little, does not make a program too long.
-- The wall clock is the limit of a child that waits. Times are arguments, seconds. Pure.
module Rosy.Worker.TimeBudget
  ( TimeBudget,
    newBudget,
    nextReview,
    review,
  )
where

data TimeBudget = TimeBudget
  { -- | Processor time after which the child has worked for too long.
    mostComputed :: Double,
    -- | When it ends in any case; on the wall clock.
    expires :: Double,
    -- | When to look again; on the wall clock.
    nextReview :: Double
  }
  deriving (Eq, Show)

-- | For so many seconds, from now on, of a child that has used this processor time before.
newBudget :: Double -> Double -> Double -> TimeBudget
newBudget seconds now computed = TimeBudget (computed + seconds) (now + patience * seconds) (now + seconds)

-- | The budget after a look at the child; nothing when it is used up.
review :: Double -> Double -> TimeBudget -> Maybe TimeBudget
review now computed budget
  | computed >= mostComputed budget || now >= expires budget = Nothing
  | otherwise = Just budget {nextReview = min (expires budget) (now + max shortestPause (mostComputed budget - computed))}

-- | Wall-clock seconds for each second of processor time.
patience :: Double
patience = 5

-- | Between two looks, seconds.
shortestPause :: Double
shortestPause = 0.05
