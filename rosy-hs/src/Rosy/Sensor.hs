{-# LANGUAGE DefaultSignatures #-}
{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeApplications #-}

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
  )
where

import Data.Dynamic (fromDynamic, toDyn)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy (..))
import Data.Typeable (typeRep)
import GHC.Generics (Generic)
import Rosy.Core
import Rosy.Robot
import Rosy.Sense
import Rosy.Value
import System.Random (StdGen)

-- | A type that a function may take. For a type that the program declares the instance is empty: it is an event of its own.
class Sensor a where
  -- | When there is a value of this type, and which.
  sense :: Sense a
  default sense :: Value a => Sense a
  sense = event userInterest fromEvent
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
-- The robot

message :: Value a => Message -> (Message -> Maybe a) -> Sense a
message like pick = event (interestIn (Sensed like)) fromSensed
  where
    fromSensed (Sensed m) = pick m
    fromSensed _ = Nothing

bumpers :: Value a => (Bumper -> Maybe a) -> Sense a
bumpers view = message (BumperMessage (Bumper LeftBumper Pressed)) (\case BumperMessage b -> view b; _ -> Nothing)

cliffs :: Value a => (Cliff -> Maybe a) -> Sense a
cliffs view = message (CliffMessage (Cliff LeftCliff Hole)) (\case CliffMessage c -> view c; _ -> Nothing)

wheels :: Value a => (Wheel -> Maybe a) -> Sense a
wheels view = message (WheelMessage (Wheel LeftWheel Air)) (\case WheelMessage w -> view w; _ -> Nothing)

buttons :: Value a => (Button -> Maybe a) -> Sense a
buttons view = message (ButtonMessage (Button Button0 Pressed)) (\case ButtonMessage b -> view b; _ -> Nothing)

instance Sensor Bumper where sense = bumpers Just

instance Sensor BumperLeft where sense = bumpers (\(Bumper side s) -> if side == LeftBumper then Just (BumperLeft s) else Nothing)

instance Sensor BumperCenter where sense = bumpers (\(Bumper side s) -> if side == CenterBumper then Just (BumperCenter s) else Nothing)

instance Sensor BumperRight where sense = bumpers (\(Bumper side s) -> if side == RightBumper then Just (BumperRight s) else Nothing)

instance Sensor Cliff where sense = cliffs Just

instance Sensor CliffLeft where sense = cliffs (\(Cliff side s) -> if side == LeftCliff then Just (CliffLeft s) else Nothing)

instance Sensor CliffCenter where sense = cliffs (\(Cliff side s) -> if side == CenterCliff then Just (CliffCenter s) else Nothing)

instance Sensor CliffRight where sense = cliffs (\(Cliff side s) -> if side == RightCliff then Just (CliffRight s) else Nothing)

instance Sensor Wheel where sense = wheels Just

instance Sensor WheelLeft where sense = wheels (\(Wheel side s) -> if side == LeftWheel then Just (WheelLeft s) else Nothing)

instance Sensor WheelRight where sense = wheels (\(Wheel side s) -> if side == RightWheel then Just (WheelRight s) else Nothing)

instance Sensor Button where sense = buttons Just

instance Sensor ButtonZero where sense = buttons (\(Button n s) -> if n == Button0 then Just (ButtonZero s) else Nothing)

instance Sensor ButtonOne where sense = buttons (\(Button n s) -> if n == Button1 then Just (ButtonOne s) else Nothing)

instance Sensor ButtonTwo where sense = buttons (\(Button n s) -> if n == Button2 then Just (ButtonTwo s) else Nothing)

instance Sensor RobotStatus where
  sense = message (StatusMessage Online) (\case StatusMessage s -> Just s; _ -> Nothing)

instance Sensor Velocity where sense = state odometryVelocity

instance Sensor Position where sense = state odometryPosition

instance Sensor Orientation where sense = state odometryOrientation

instance Sensor Pose where sense = state (\o -> Pose (odometryPosition o) (odometryOrientation o))

-- ---------------------------------------------------------------------------------------------
-- Samples

instance Sensor Seconds where sense = sample (Seconds . envTime)

instance Sensor Clock where sense = sample (clockAt . envTime)

-- | A fresh generator each time it is read; two inputs of one function differ.
instance Sensor StdGen where sense = chance

instance Default a => Sensor (Memory a) where
  sense = sample (\env -> Memory (recall (IntMap.findWithDefault Map.empty (envScope env) (envMemories env))))

instance Default a => Sensor (Param a) where
  sense = sample (Param . recall . envParams)

recall :: forall a. Default a => Memories -> a
recall memories = case Map.lookup (typeRep (Proxy @a)) memories of
  Just (Kept value _) -> fromMaybe defaultValue (fromDynamic value)
  Nothing -> defaultValue

-- | Hours, minutes, seconds and milliseconds of so many seconds, round the clock.
clockAt :: Double -> Clock
clockAt time = Clock (s `div` 3600 `mod` 24) (s `div` 60 `mod` 60) (s `mod` 60) ms
  where
    -- The simulator counts steps of 20 ms: half a millisecond more absorbs the rounding of 0.02 * k.
    (s, ms) = (floor (time * 1000 + 0.5) :: Int) `divMod` 1000

-- ---------------------------------------------------------------------------------------------
-- Shapes

instance Sensor () where sense = tick

instance Sensor Never where sense = never

instance (Sensor a, Sensor b) => Sensor (Either a b) where
  sense = oneOf sense sense

instance Sensor a => Sensor (Maybe a) where
  sense = convert (either Just (const Nothing)) (maybe (Right ()) Left) (oneOf sense tick)

instance (Sensor a, Sensor b) => Sensor (a, b) where
  sense = both sense sense

instance (Sensor a, Sensor b, Sensor c) => Sensor (a, b, c) where
  sense = convert (\(a, (b, c)) -> (a, b, c)) (\(a, b, c) -> (a, (b, c))) sense

instance (Sensor a, Sensor b, Sensor c, Sensor d) => Sensor (a, b, c, d) where
  sense = convert (\(a, (b, c, d)) -> (a, b, c, d)) (\(a, b, c, d) -> (a, (b, c, d))) sense

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e) => Sensor (a, b, c, d, e) where
  sense = convert (\(a, (b, c, d, e)) -> (a, b, c, d, e)) (\(a, b, c, d, e) -> (a, (b, c, d, e))) sense

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e, Sensor f) => Sensor (a, b, c, d, e, f) where
  sense = convert (\(a, (b, c, d, e, f)) -> (a, b, c, d, e, f)) (\(a, b, c, d, e, f) -> (a, (b, c, d, e, f))) sense

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e, Sensor f, Sensor g) => Sensor (a, b, c, d, e, f, g) where
  sense = convert (\(a, (b, c, d, e, f, g)) -> (a, b, c, d, e, f, g)) (\(a, b, c, d, e, f, g) -> (a, (b, c, d, e, f, g))) sense

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e, Sensor f, Sensor g, Sensor h) => Sensor (a, b, c, d, e, f, g, h) where
  sense = convert (\(a, (b, c, d, e, f, g, h)) -> (a, b, c, d, e, f, g, h)) (\(a, b, c, d, e, f, g, h) -> (a, (b, c, d, e, f, g, h))) sense

instance (Sensor a, Sensor b, Sensor c, Sensor d, Sensor e, Sensor f, Sensor g, Sensor h, Sensor i) => Sensor (a, b, c, d, e, f, g, h, i) where
  sense = convert (\(a, (b, c, d, e, f, g, h, i)) -> (a, b, c, d, e, f, g, h, i)) (\(a, b, c, d, e, f, g, h, i) -> (a, (b, c, d, e, f, g, h, i))) sense
