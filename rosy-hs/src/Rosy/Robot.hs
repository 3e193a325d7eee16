{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE GeneralizedNewtypeDeriving #-}

-- |
-- Module      : Rosy.Robot
-- Description : The nouns of the robot: what a Kobuki senses and what it can be told.
--
-- One type per message of the base, with the constructor order and the words of LANGUAGE.md section 1.
-- Units are SI: metres, radians counter-clockwise, seconds. This module holds data only;
-- how a type enters or leaves a program is in "Rosy.Sensor" and "Rosy.Command". All of it is exported, and "Rosy"
-- exports all of it to learners, in a reading order.
--
-- Decision: a button and a bumper share one status type, so that @Pressed@ is written for both
-- without qualification. The one-sided views of the buttons are 'ButtonZero', 'ButtonOne' and 'ButtonTwo',
-- because 'Button0' is the number in @Button Button0 Pressed@ and one name cannot be both.
module Rosy.Robot where

import GHC.Generics (Generic)
import Rosy.Value (Default, Value (..))

-- | A bumper was pressed or released.
data Bumper = Bumper !BumperSide !BumperStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | Where a bumper sits; the three zones cover the front half of the base.
data BumperSide = LeftBumper | CenterBumper | RightBumper
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | Bumpers and buttons are pressed and released alike.
type BumperStatus = ButtonStatus

-- | A cliff sensor looks down at the floor in front of a wheel or under the nose.
data Cliff = Cliff !CliffSide !CliffStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | Where a cliff sensor sits.
data CliffSide = LeftCliff | CenterCliff | RightCliff
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | What a cliff sensor sees below it.
data CliffStatus = Hole | Floor
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | A wheel dropped (the robot was lifted or drove over an edge) or found the ground again.
data Wheel = Wheel !WheelSide !WheelStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | Which of the two driven wheels.
data WheelSide = LeftWheel | RightWheel
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | Whether a wheel hangs in the air.
data WheelStatus = Air | Ground
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | One of the three buttons on top was pressed or released.
data Button = Button !ButtonNumber !ButtonStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | Which button; they are marked B0, B1 and B2 on the base.
data ButtonNumber = Button0 | Button1 | Button2
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | Pressed or released, of buttons and bumpers.
data ButtonStatus = Pressed | Released
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | The base went on line or off line.
data RobotStatus = Online | Offline
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | The left bumper only.
newtype BumperLeft = BumperLeft BumperStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | The center bumper only.
newtype BumperCenter = BumperCenter BumperStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | The right bumper only.
newtype BumperRight = BumperRight BumperStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | The left cliff sensor only.
newtype CliffLeft = CliffLeft CliffStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | The center cliff sensor only.
newtype CliffCenter = CliffCenter CliffStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | The right cliff sensor only.
newtype CliffRight = CliffRight CliffStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | The left wheel only.
newtype WheelLeft = WheelLeft WheelStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | The right wheel only.
newtype WheelRight = WheelRight WheelStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | Button 0 only.
newtype ButtonZero = ButtonZero ButtonStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | Button 1 only.
newtype ButtonOne = ButtonOne ButtonStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | Button 2 only.
newtype ButtonTwo = ButtonTwo ButtonStatus
  deriving (Eq, Ord, Show, Read, Generic)

-- | How fast the robot moves: forwards in m\/s, turning in rad\/s (counter-clockwise positive).
-- As a sensor it is what odometry measured; as a command it is what the wheels should do next.
data Velocity = Velocity !Double !Double
  deriving (Eq, Ord, Show, Read, Generic)

-- | The forward part of a velocity, m/s.
velocityLinear :: Velocity -> Double
velocityLinear (Velocity v _) = v

-- | The turning part of a velocity, rad/s.
velocityAngular :: Velocity -> Double
velocityAngular (Velocity _ w) = w

-- | Where the robot is, in metres: x and y, with the place where it started as the origin and its first heading along x.
data Position = Position !Double !Double
  deriving (Eq, Ord, Show, Read, Generic)

-- | Metres ahead of the start, in the direction the robot looked then.
positionX :: Position -> Double
positionX (Position x _) = x

-- | Metres to the left of the start.
positionY :: Position -> Double
positionY (Position _ y) = y

-- | Where the robot looks, in radians; 0 is where it looked at the start. A number like any other.
newtype Orientation = Orientation Double
  deriving (Eq, Ord, Show, Read, Generic, Num, Fractional, Floating, Real, RealFrac, RealFloat, Enum)

-- | Position and orientation together.
data Pose = Pose !Position !Orientation
  deriving (Eq, Ord, Show, Read, Generic)

-- | The place of a pose.
posePosition :: Pose -> Position
posePosition (Pose p _) = p

-- | The heading of a pose.
poseOrientation :: Pose -> Orientation
poseOrientation (Pose _ o) = o

-- | Seconds since the program started on a simulator, since 1970 on a robot. A number like any other.
newtype Seconds = Seconds Double
  deriving (Eq, Ord, Show, Read, Generic, Num, Fractional, Floating, Real, RealFrac, RealFloat, Enum)

-- | The time of day: hours, minutes, seconds and milliseconds. On a simulator the day begins with the program;
-- on a robot it is universal time (UTC).
data Clock = Clock !Int !Int !Int !Int
  deriving (Eq, Ord, Show, Read, Generic)

-- | The colours of the two lights.
data LedColor = Black | Green | Orange | Red
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | Set the first light.
newtype Led1 = Led1 LedColor
  deriving (Eq, Ord, Show, Read, Generic)

-- | Set the second light.
newtype Led2 = Led2 LedColor
  deriving (Eq, Ord, Show, Read, Generic)

-- | Play one of the seven sounds of the base.
data Sound
  = OnSound
  | OffSound
  | RechargeSound
  | ButtonSound
  | ErrorSound
  | CleaningStartSound
  | CleaningEndSound
  deriving (Eq, Ord, Show, Read, Enum, Bounded, Generic)

-- | Write a line in the console and in a bubble over the robot.
newtype Say = Say String
  deriving (Eq, Ord, Show, Read, Generic)

instance Value Bumper

instance Default Bumper

instance Value BumperSide

instance Default BumperSide

instance Value Cliff

instance Default Cliff

instance Value CliffSide

instance Default CliffSide

instance Value CliffStatus

instance Default CliffStatus

instance Value Wheel

instance Default Wheel

instance Value WheelSide

instance Default WheelSide

instance Value WheelStatus

instance Default WheelStatus

instance Value Button

instance Default Button

instance Value ButtonNumber

instance Default ButtonNumber

instance Value ButtonStatus

instance Default ButtonStatus

instance Value RobotStatus

instance Default RobotStatus

instance Value BumperLeft

instance Default BumperLeft

instance Value BumperCenter

instance Default BumperCenter

instance Value BumperRight

instance Default BumperRight

instance Value CliffLeft

instance Default CliffLeft

instance Value CliffCenter

instance Default CliffCenter

instance Value CliffRight

instance Default CliffRight

instance Value WheelLeft

instance Default WheelLeft

instance Value WheelRight

instance Default WheelRight

instance Value ButtonZero

instance Default ButtonZero

instance Value ButtonOne

instance Default ButtonOne

instance Value ButtonTwo

instance Default ButtonTwo

instance Value Velocity

instance Default Velocity

instance Value Position

instance Default Position

instance Value Orientation

instance Default Orientation

instance Value Pose

instance Default Pose

instance Value Seconds

instance Default Seconds

instance Value Clock

instance Default Clock

instance Value LedColor

instance Default LedColor

instance Value Led1

instance Default Led1

instance Value Led2

instance Default Led2

instance Value Sound

instance Default Sound

instance Value Say

instance Default Say
