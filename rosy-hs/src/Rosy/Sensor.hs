{-# LANGUAGE DefaultSignatures #-}
{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeApplications #-}
{-# LANGUAGE UnboxedTuples #-}

-- |
-- Module      : Rosy.Sensor
-- Description : The types a function may take.
--
-- > Bumper -> …                      -- an event: fires at each
-- > Bumper -> Velocity -> …          -- at each bumper event, with the velocity of that moment
-- > Velocity -> …                    -- at each odometry message, 50 Hz
-- > Seconds -> Memory Bool -> …      -- samples only: at the default rate, 10 Hz
-- > Either Bumper Cliff -> …         -- at each of both
-- > Maybe Bumper -> …                -- at each, and at the default rate without one
--
-- You need this class only to read an error message: a type that is not a 'Sensor' cannot be sensed.
module Rosy.Sensor
  ( -- * What it is
    Sensor (..),

    -- * Special inputs
    Memory (..),
    Param (..),
    Never (..),

    -- * For the instances of robots
    sensedEvent,
    sensedState,
  )
where

import Data.Dynamic (fromDynamic, toDyn)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import Data.Typeable (typeRep, typeRepFingerprint)
import GHC.Generics (Generic)
import Rosy.Core
import Rosy.Sense
import Rosy.Time
import Rosy.Value
import System.Random (StdGen)

-- | A type that a function may take. For a type that the program declares the instance is empty: it is an event of its own. With a method it is
-- connected to a topic of the robot:
--
-- > instance Sensor Charge where
-- >   sensor = topic "/battery_state" "sensor_msgs/BatteryState" (Charge <$> field "percentage")
class Sensor a where
  -- | When there is a value of this type, and which.
  sensor :: Sense a
  default sensor :: Value a => Sense a
  sensor = event userInterest fromEvent
    where
      fromEvent (Emitted e) = fromDynamic (eventValue e)
      fromEvent _ = Nothing

userInterest :: Interest
userInterest = interestIn (Emitted (Event 0 (toDyn ()) ""))

-- | What a function remembers. It starts at the first value of its type, and belongs to the running task.
newtype Memory a = Memory a
  deriving (Eq, Ord, Show, Read, Generic)

-- | Like 'Memory', but shared by all tasks of the program.
newtype Param a = Param a
  deriving (Eq, Ord, Show, Read, Generic)

-- | Never happens as an input; does nothing as an output.
data Never = Never
  deriving (Eq, Ord, Show, Read, Generic)

instance Value a => Value (Memory a)

instance Value a => Value (Param a)

instance Value Never

-- ---------------------------------------------------------------------------------------------
-- Samples

instance Sensor Seconds where sensor = sample FromTime (\env -> (# Seconds (envTime env) #))

instance Sensor Clock where sensor = sample FromTime (\env -> (# clockAt (envClock env + envTime env) #))

-- | A fresh generator each time it is read; two inputs of one function differ.
instance Sensor StdGen where sensor = chance

instance Default a => Sensor (Memory a) where
  sensor = sample (FromMemory (typeRep (Proxy @a))) look
    where
      look env = case recall (IntMap.findWithDefault Map.empty (envScope env) (envMemories env)) of (# x #) -> (# Memory x #)

instance Default a => Sensor (Param a) where
  sensor = sample (FromParam (typeRep (Proxy @a))) (\env -> case recall (envParams env) of (# x #) -> (# Param x #))

-- | The remembered value of this type. The default is not evaluated, because a program may define one that fails.
recall :: forall a. Default a => Memories -> (# a #)
recall memories = case Map.lookup (typeRepFingerprint (typeRep (Proxy @a))) memories of
  Just (Kept value _) | Just x <- fromDynamic value -> (# x #)
  _ -> (# defaultValue #)

-- ---------------------------------------------------------------------------------------------
-- Shapes

instance Sensor () where sensor = tick

instance Sensor Never where sensor = never

instance (Sensor a, Sensor b) => Sensor (Either a b) where
  sensor = oneOf sensor sensor

instance Sensor a => Sensor (Maybe a) where
  sensor = convert (either Just (const Nothing)) (maybe (Right ()) Left) (oneOf sensor tick)

instance (Sensor a, Sensor b) => Sensor (a, b) where
  sensor = both sensor sensor

instance (Sensor a, Sensor b, Sensor c) => Sensor (a, b, c) where
  sensor = convert (\(a, (b, c)) -> (a, b, c)) (\(a, b, c) -> (a, (b, c))) sensor

instance (Sensor a, Sensor b, Sensor c, Sensor d) => Sensor (a, b, c, d) where
  sensor = convert (\(a, (b, c, d)) -> (a, b, c, d)) (\(a, b, c, d) -> (a, (b, c, d))) sensor

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e) => Sensor (a, b, c, d, e) where
  sensor = convert (\(a, (b, c, d, e)) -> (a, b, c, d, e)) (\(a, b, c, d, e) -> (a, (b, c, d, e))) sensor

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e, Sensor f) => Sensor (a, b, c, d, e, f) where
  sensor = convert (\(a, (b, c, d, e, f)) -> (a, b, c, d, e, f)) (\(a, b, c, d, e, f) -> (a, (b, c, d, e, f))) sensor

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e, Sensor f, Sensor g) => Sensor (a, b, c, d, e, f, g) where
  sensor = convert (\(a, (b, c, d, e, f, g)) -> (a, b, c, d, e, f, g)) (\(a, b, c, d, e, f, g) -> (a, (b, c, d, e, f, g))) sensor

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e, Sensor f, Sensor g, Sensor h) => Sensor (a, b, c, d, e, f, g, h) where
  sensor = convert (\(a, (b, c, d, e, f, g, h)) -> (a, b, c, d, e, f, g, h)) (\(a, b, c, d, e, f, g, h) -> (a, (b, c, d, e, f, g, h))) sensor

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e, Sensor f, Sensor g, Sensor h, Sensor i) => Sensor (a, b, c, d, e, f, g, h, i) where
  sensor = convert (\(a, (b, c, d, e, f, g, h, i)) -> (a, b, c, d, e, f, g, h, i)) (\(a, b, c, d, e, f, g, h, i) -> (a, (b, c, d, e, f, g, h, i))) sensor
