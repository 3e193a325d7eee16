{-# LANGUAGE DeriveTraversable #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Robots.Expiry
-- Description : Time to live of a movement on its way to the robot.
--
-- In: a command and the time at which it was decided ('Rosy.Robots.BootClock.bootSeconds'). Out: what is written at the time of writing: the
-- command, or zero velocity for a movement that is too old. A process can be suspended, or its computer sleep, between a decision of the
-- guard and the write; the guardian has stopped the robot meanwhile, and the movement would start it again. Each link asks 'valueAt' right before its write.
-- Pure; time is an argument.
module Rosy.Robots.Expiry
  ( Expiring,
    lasting,
    expiring,
    hasExpired,
    valueAt,
  )
where

import Rosy.Channel (Action)
import Rosy.Robot (Velocity (..), pattern VelocityCommand)
import Rosy.Robots.Guard (longestAbsence)

-- | A value, and until when it counts, seconds, with what counts afterwards.
data Expiring a = Expiring !a !(Maybe (Double, a))
  deriving (Eq, Show, Functor, Foldable, Traversable)

-- | A value that always counts.
lasting :: a -> Expiring a
lasting a = Expiring a Nothing

-- | A command that was decided at this time: a movement counts for 'longestAbsence', and zero velocity afterwards. Other commands always count.
expiring :: Double -> Action -> Expiring Action
expiring decided a = case a of
  VelocityCommand v | v /= still -> Expiring a (Just (decided + longestAbsence, VelocityCommand still))
  _ -> lasting a
  where
    still = Velocity 0 0

-- | Whether the value does not count any more at this time.
hasExpired :: Double -> Expiring a -> Bool
hasExpired t (Expiring _ until') = maybe False ((t >) . fst) until'

-- | What counts at this time.
valueAt :: Double -> Expiring a -> a
valueAt t e@(Expiring a until') = case until' of
  Just (_, afterwards) | hasExpired t e -> afterwards
  _ -> a
