-- |
-- Module      : Rosy
-- Description : The only import a learner writes.
--
-- A program is ordinary functions from what the robot senses to what it should do.
--
-- > main = simulate (accelerate, play)
-- >
-- > accelerate :: Velocity -> Velocity
-- > accelerate (Velocity v w) = Velocity (v + 0.5) w
-- >
-- > play :: Bumper -> Maybe Sound
-- > play (Bumper _ Pressed) = Just ErrorSound
-- > play _                  = Nothing
--
-- Read the list from top to bottom: each group needs only those above it.
module Rosy
  ( -- * Run it
    simulate,

    -- * Tell the robot
    Velocity (..),
    Led1 (..),
    Led2 (..),
    LedColor (..),
    Sound (..),
    Say (..),

    -- * What happened
    Bumper (..),
    BumperSide (..),
    BumperStatus,
    Cliff (..),
    CliffSide (..),
    CliffStatus (..),
    Wheel (..),
    WheelSide (..),
    WheelStatus (..),
    Button (..),
    ButtonNumber (..),
    ButtonStatus (..),
    RobotStatus (..),

    -- ** On one side
    BumperLeft (..),
    BumperCenter (..),
    BumperRight (..),
    CliffLeft (..),
    CliffCenter (..),
    CliffRight (..),
    WheelLeft (..),
    WheelRight (..),
    ButtonZero (..),
    ButtonOne (..),
    ButtonTwo (..),

    -- * Where it is and how it moves
    Position (..),
    Orientation (..),
    Pose (..),
    velocityLinear,
    velocityAngular,
    positionX,
    positionY,
    posePosition,
    poseOrientation,

    -- * Remember
    Memory (..),

    -- * Time and chance
    -- $chance
    Seconds (..),
    doubleToSeconds,
    secondsToDouble,
    Clock (..),
    StdGen,
    random,
    randomR,

    -- * One thing after another
    Task,
    task,
    Done (..),
    once,
    say,
    wait,
    parallel,
    race,

    -- * Tasks with more
    Param (..),
    taskWith,
    TaskOptions (..),
    taskOptions,
    call,
    Call,
    CallOptions (..),
    callOptions,
    Feedback (..),
    Cancel (..),
    Never (..),

    -- * Angles and places
    Degrees,
    Radians,
    Centimeters,
    Meters,
    degreesToOrientation,
    orientationToDegrees,
    normOrientation,
    degreesToRadians,
    radiansToDegrees,
    normRadians,
    centimetersToMeters,
    metersToCentimeters,
    Vec,
    positionToVec,
    vecToPosition,
    scalarVec,
    magnitudeVec,
    angleVec,
    addVec,
    subVec,
    extVec,

    -- * Words for signatures
    -- $signatures
    Sensor,
    Command,
    Controller,
    Runnable,
    Default,
    Random,
    RandomGen,
    Alternative,
    Typeable,

    -- * Haskell's vocabulary for doing things again and again
    -- $again
    module Control.Monad,
  )
where

import Control.Applicative (Alternative)
import Control.Monad
import Data.Typeable (Typeable)
import Rosy.Command
import Rosy.Controller
import Rosy.Geometry
import Rosy.Launch
import Rosy.Robot
import Rosy.Runnable
import Rosy.Sensor
import Rosy.Task
import Rosy.Value (Default)
import System.Random (Random, RandomGen, StdGen, random, randomR)

-- $chance
-- A function that takes a 'StdGen' gets a fresh source of chance each time it fires; the same seed of a run gives the same chances again.
-- 'random' and 'randomR' draw from it, and give the source to draw from next:
--
-- > turn :: StdGen -> Velocity
-- > turn gen = Velocity 0 (fst (randomR (-1, 1) gen))

-- $signatures
-- What a function with a type variable asks of it. Most functions need none of these; a signature that GHC or the blocks find may have one:
--
-- > dice :: (Random a, RandomGen g) => a -> a -> g -> a
-- > dice low high gen = fst (randomR (low, high) gen)

-- $again
-- These come with Haskell, and are here without an import. They work for tasks as for everything else that can be done one after another.
--
-- #v:forever# @forever :: Task a -> Task b@
--
-- Do it again and again, without an end: @forever (drive >> turn)@.
--
-- #v:replicateM_# @replicateM_ :: Int -> Task a -> Task ()@
--
-- Do it so many times: @replicateM_ 4 (move >> turn)@.
--
-- #v:replicateM# @replicateM :: Int -> Task a -> Task [a]@
--
-- Do it so many times, and collect the results.
--
-- #v:when# @when :: Bool -> Task () -> Task ()@
--
-- Do it only if it is so.
--
-- #v:unless# @unless :: Bool -> Task () -> Task ()@
--
-- Do it only if it is not so.
--
-- #v:mapM_# @mapM_ :: (a -> Task b) -> [a] -> Task ()@
--
-- Do it with each element of a list: @mapM_ say ["one", "two"]@.
--
-- #v:mapM# @mapM :: (a -> Task b) -> [a] -> Task [b]@
--
-- The same, and collect the results.
--
-- #v:forM_# @forM_ :: [a] -> (a -> Task b) -> Task ()@
--
-- The list first: @forM_ [1 .. 4] step@.
--
-- #v:forM# @forM :: [a] -> (a -> Task b) -> Task [b]@
--
-- The same, and collect the results.
--
-- #v:void# @void :: Task a -> Task ()@
--
-- Do it, and forget the result.
