-- |
-- Module      : Rosy.Profile
-- Description : Robots as data: topics, message fields and serial packets of each channel, and the robot's limits.
--
-- The values of these types are in "Rosy.Robot.Known", which is generated from @protocol/robots@. A topic and a message
-- type are patterns: @{prefix}\/events\/bumper@ becomes a topic with the variables of a profile.
module Rosy.Profile
  ( -- * Robots
    Robot (..),
    Variables,
    expand,

    -- * Messages
    Mapping (..),
    Delivery (..),
    Place (..),
    Leaf (..),
    Step (..),
    Level (..),

    -- * Serial packets
    Serial (..),
    Width (..),
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Channel

-- | A robot that programs can drive.
data Robot = Robot
  { robotName :: String,
    -- | Variables of its topics, by profile: @ros1@ first, then @ros2@.
    robotProfiles :: [(String, Variables)],
    robotMappings :: [Mapping],
    -- | The commands that last, as they are when the robot is switched on: one value, or one per place.
    robotHeld :: [(Channel, [Field])],
    -- | Highest speed, m\/s, and turn, rad\/s.
    robotLimits :: (Double, Double),
    -- | Highest speed of a wheel, m\/s, and the distance between the wheels, m, of a robot for which both are documented.
    robotWheels :: Maybe (Double, Double),
    -- | The sensors that measure only while a program listens.
    robotOnDemand :: [Channel],
    -- | Packets on a serial line, by channel; none when it has no serial line.
    robotSerial :: [(Channel, Serial)],
    -- | Texts of the ROS message definitions in use: package, name, text.
    robotMessages :: [(String, String, String)]
  }

-- | Names and values; a value may contain other variables.
type Variables = [(String, String)]

-- | Replaces @{name}@ by the value of a variable, also in values.
expand :: Variables -> Text -> Text
expand variables text = case Text.breakOn (Text.pack "{") text of
  (before, rest)
    | Just (name, after) <- split rest,
      Just value <- lookup (Text.unpack name) variables ->
      before <> expand variables (Text.pack value) <> expand variables after
  _ -> text
  where
    split rest = case Text.breakOn (Text.pack "}") (Text.drop 1 rest) of
      (name, after) | not (Text.null after) -> Just (name, Text.drop 1 after)
      _ -> Nothing

-- | How a channel travels in ROS messages.
data Mapping = Mapping
  { mappingChannel :: Channel,
    topicPattern :: Text,
    typePattern :: Text,
    -- | One per field of the channel; none when the message has 'mappingLevels'.
    mappingPlaces :: [Place],
    -- | Whether each place of an event channel is on. Every message says so of all places, and only changes are events.
    mappingLevels :: [Level],
    -- | Fields of the message that are always the same, as JSON.
    mappingConstants :: [([Step], Text)],
    mappingDelivery :: Delivery
  }

-- | How messages reach their receivers.
data Delivery
  = Published
  | -- | Late subscribers get the last message.
    Latched
  | -- | The message is the request of a service.
    Called
  deriving (Eq, Show)

-- | Where a field is in a message.
data Place
  = At [Step] Leaf
  | -- | A heading about the vertical axis, in the @z@ and @w@ of a quaternion.
    Yaw [Step]
  | -- | The same in several places.
    AtAll [[Step]] Leaf
  | -- | In a laser scan, how far the way ahead is free: the nearest of the beams that are at most this angle (rad) from straight ahead.
    NearestAhead Double
  | -- | The distances of a laser scan. They are the last fields of their channel.
    ScanRanges
  deriving (Eq, Show)

-- | A truth in a message.
data Level
  = -- | A truth or a bit is set.
    IsSet [Step] Leaf
  | -- | The list at the first path has an entry whose number at the second path is this one and whose text at the third path is one of
    -- these, or, with 'False', none of these.
    HasEntry [Step] ([Step], Int) [Step] Bool [Text]
  deriving (Eq, Show)

-- | What is at a place.
data Leaf
  = -- | A number, multiplied by this in the field.
    ANumber Double
  | AWhole
  | ATruth
  | AText
  | -- | This bit of a whole number: 0 or 1.
    ABit Int
  | -- | A set of flags, of which the field is the first of these that is set, or 0.
    TheFirstOf [Int]
  | -- | A choice that the message writes as other JSON values, by code.
    ACode [(Int, Text)]
  deriving (Eq, Show)

-- | A step from the top of a message to a field.
data Step = Key Text | Index Int
  deriving (Eq, Show)

-- | How a channel travels in serial packets: the number of a part of a packet, and the place in it.
data Serial
  = -- | Sensors that report changes: byte, and the bit of each sensor.
    Edges Int Int [Int]
  | -- | A value per field: byte, width, factor and what it may be decoded as.
    Values Int [(Int, Width, Leaf)]
  | -- | Bits of the combined output word: first bit of the first place, and the bits of each code.
    Output Int [Int]
  | -- | A command with one byte.
    Command Int
  deriving (Eq, Show)

-- | Width and sign of a number in a packet, little-endian.
data Width = U8 | I16 | U16
  deriving (Eq, Show)
