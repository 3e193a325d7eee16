-- |
-- Module      : Rosy.Kobuki.Feedback
-- Description : Decoder of feedback packets.
--
-- In: the parts of a payload. Out: those with odometry and versions; "Rosy.Robots.SerialCodec" reads the others. Numbers are little-endian.
-- Identifiers and lengths are those of kobuki_driver's "Protocol Specification", Feedback Packets.
module Rosy.Kobuki.Feedback
  ( Feedback (..),
    Core (..),
    Inertia (..),
    Version (..),
    readFeedback,
    hardwareVersion,
    firmwareVersion,
    coreOf,
    inertiaOf,
  )
where

import Data.Bits (shiftL, (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import Data.Int (Int16)
import Data.Maybe (listToMaybe)
import Data.Word (Word16, Word32, Word8)
import Rosy.Robots.SerialCodec (Parts)

data Feedback
  = CoreSensors Core
  | InertiaSensor Inertia
  | Hardware Version
  | Firmware Version
  | -- | The base's serial number.
    Udid Word32 Word32 Word32
  | -- | Something that this program does not need, by identifier.
    Other Word8
  deriving (Eq, Show)

-- | Identifier 1, in every packet.
data Core = Core
  { -- | ms, wraps at 65536
    timeStamp :: !Word16,
    -- | right 1, centre 2, left 4
    bumpers :: !Word8,
    -- | right 1, left 2
    wheelDrops :: !Word8,
    -- | right 1, centre 2, left 4
    cliffs :: !Word8,
    -- | ticks, wraps at 65536
    leftEncoder, rightEncoder :: !Word16,
    -- | button n is bit n
    buttons :: !Word8
  }
  deriving (Eq, Show)

-- | Identifier 4, in every packet.
data Inertia = Inertia
  { -- | 0.01 degrees
    angle :: !Int16,
    -- | 0.01 degrees/s
    angleRate :: !Int16
  }
  deriving (Eq, Show)

-- | Major, minor, patch.
data Version = Version Int Int Int
  deriving (Eq, Ord, Show)

-- | What the parts of a payload say that needs more than a table: odometry and versions.
readFeedback :: Parts -> [Feedback]
readFeedback = map (uncurry part)

part :: Word8 -> ByteString -> Feedback
part ident d
  | ident == 1 && B.length d >= 15 =
    CoreSensors (Core (u16 0) (u8 2) (u8 3) (u8 4) (u16 5) (u16 7) (u8 11))
  | ident == 4 && B.length d >= 4 = InertiaSensor (Inertia (fromIntegral (u16 0)) (fromIntegral (u16 2)))
  | ident == 10 && B.length d >= 2 = Hardware version
  | ident == 11 && B.length d >= 2 = Firmware version
  | ident == 19 && B.length d >= 12 = Udid (u32 0) (u32 4) (u32 8)
  | otherwise = Other ident
  where
    u8 = B.index d
    u16 i = fromIntegral (u8 i) .|. (fromIntegral (u8 (i + 1)) `shiftL` 8) :: Word16
    u32 i = fromIntegral (u16 i) .|. (fromIntegral (u16 (i + 2)) `shiftL` 16) :: Word32
    -- Patch, minor, major; old firmware sends two bytes, minor and major.
    version
      | B.length d >= 4 = Version (fromIntegral (u8 2)) (fromIntegral (u8 1)) (fromIntegral (u8 0))
      | otherwise = Version (fromIntegral (u8 1)) (fromIntegral (u8 0)) 0

coreOf :: [Feedback] -> Maybe Core
coreOf fs = listToMaybe [c | CoreSensors c <- fs]

inertiaOf :: [Feedback] -> Maybe Inertia
inertiaOf fs = listToMaybe [i | InertiaSensor i <- fs]

hardwareVersion, firmwareVersion :: [Feedback] -> Maybe Version
hardwareVersion fs = listToMaybe [v | Hardware v <- fs]
firmwareVersion fs = listToMaybe [v | Firmware v <- fs]
