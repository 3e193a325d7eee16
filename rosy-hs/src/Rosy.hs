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
    Sensor,
    Command,
    Controller,
    Runnable,

    -- * Haskell's vocabulary for doing things again and again
    module Control.Monad,
  )
where

import Control.Monad
import Rosy.Command
import Rosy.Controller
import Rosy.Geometry
import Rosy.Launch
import Rosy.Robot
import Rosy.Runnable
import Rosy.Sensor
import Rosy.Task
import System.Random (StdGen, random, randomR)
