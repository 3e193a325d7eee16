-- |
-- Module      : Rosy.Loop.Quiescence
-- Description : Quiescence of a network: what must happen before anything in it can fire or go on.
--
-- A bound from the safe side: what is said here not to matter changes nothing but the current values of the states. So a simulator need
-- not ask a program in steps in which nothing else happens.
module Rosy.Loop.Quiescence
  ( Quiescence (..),
    neverQuiet,
    quiescence,
  )
where

import qualified Data.Sequence as Seq
import Rosy.Arbitration (nextRelease)
import Rosy.Core
import Rosy.Loop.State

-- | How long nothing happens inside.
data Quiescence = Quiescence
  { -- | The time at which a task goes on whatever happens, seconds since the start; infinite when there is none.
    quietUntil :: !Double,
    -- | The occurrences from outside at which something may fire earlier.
    wakingInterest :: !Interest
  }
  deriving (Eq, Show)

instance Semigroup Quiescence where
  Quiescence a x <> Quiescence b y = Quiescence (min a b) (unite x y)

instance Monoid Quiescence where
  mempty = Quiescence (1 / 0) noInterest

-- | Something may happen in the next instant.
neverQuiet :: Quiescence
neverQuiet = Quiescence (-1 / 0) noInterest

-- | Of a network between two steps.
quiescence :: Network -> Quiescence
quiescence (Network running w) = case queue w of
  [] -> ofRunning running <> Quiescence (nextRelease (holds (tasks w))) noInterest
  -- Left over from more rounds than one instant has (rule R8).
  _ -> neverQuiet

ofRunning :: Running r -> Quiescence
ofRunning running = case running of
  Returned _ -> mempty
  Starting _ live _ _ -> ofLive live
  Giving _ live _ -> ofLive live
  Working _ live called _ _ -> foldMap ofLive live <> foldMap ofCalled called
  Waiting moment _ -> Quiescence moment noInterest
  Paused _ -> neverQuiet
  Beside a b _ -> ofRunning a <> ofRunning b
  Against a b _ -> ofRunning a <> ofRunning b

ofCalled :: Called -> Quiescence
ofCalled (Called running cancel _ _) = ofRunning running <> foldMap ofLive cancel

ofLive :: Live -> Quiescence
ofLive live = case live of
  Steady _ kinds _ _ _ -> wakes kinds
  Passing _ kinds _ _ _ waiting _ -> follows kinds waiting
  Keeping _ kinds _ _ _ _ waiting _ -> follows kinds waiting
  where
    wakes = Quiescence (1 / 0)
    follows kinds waiting = wakes (if Seq.null waiting then bringing kinds else offered kinds)
