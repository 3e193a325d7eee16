{-# LANGUAGE DeriveTraversable #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Robots.Expiry
-- Description : Time to live of a movement on its way to the robot.
--
-- In: a command, the time at which it was decided ('Rosy.Robots.BootClock.bootSeconds'), and the time of the guardian's last heartbeat. Out: what is written
-- at the time of writing: the command, or zero velocity for a movement if either is too long ago. A process can be suspended, or its computer sleep, between a decision of the
-- guard and the write; the guardian has stopped the robot meanwhile, and the movement would start it again. Each link asks 'valueAt' right before its write.
-- Pure; time is an argument.
module Rosy.Robots.Expiry
  ( Expiring,
    lasting,
    expiring,
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

-- | What counts at a time, when the last heartbeat was at this one: a guardian that has heard none for longer may have stopped the robot.
valueAt :: Double -> Double -> Expiring a -> a
valueAt heartbeat t (Expiring a until') = case until' of
  Just (end, afterwards) | t > end || t - heartbeat > longestAbsence -> afterwards
  _ -> a
