-- |
-- Module      : Rosy.Kobuki.Command
-- Description : Encoder of command packets.
--
-- In: speeds and commands. Out: the bytes for the serial line. Identifiers and lengths are those of
-- kobuki_driver's "Protocol Specification", Command Packets.
module Rosy.Kobuki.Command
  ( -- * Moving
    baseControl,
    wheelCommand,
    wheelbase,

    -- * Lights and power
    Outputs,
    powerOn,
    obeying,
    outputs,

    -- * The rest
    ownPacket,
    requestVersions,
  )
where

import Data.Bits (shiftR, (.&.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import Data.Int (Int16)
import Data.Word (Word16, Word8)
import Rosy.Channel (Action)
import Rosy.Kobuki.Frame (packet)
import Rosy.Kobuki.Table (serialTable)
import Rosy.Robots.SerialCodec (singleByte, withOutput)

-- | Metres between the wheels (kobuki_driver, diff_drive.cpp: bias).
wheelbase :: Double
wheelbase = 0.23

-- | Identifier 1: a speed in m/s and a turn in rad/s, within the limits of the wheels ("Rosy.Robots.Guard").
baseControl :: Double -> Double -> ByteString
baseControl v w = packet (B.pack [1, 4] <> u16 (fromIntegral speed) <> u16 (fromIntegral radius))
  where
    (speed, radius) = wheelCommand v w

-- | The speed of the outer wheel in mm/s and the radius in mm, as the driver computes them (kobuki_driver,
-- diff_drive.cpp: setVelocityCommands): radius 0 is straight on, 1 is on the spot.
wheelCommand :: Double -> Double -> (Int16, Int16)
wheelCommand v w
  | abs w < epsilon = (saturated (1000 * v), 0)
  | abs v < epsilon || abs r <= 1 = (saturated (1000 * wheelbase * w / 2), 1)
  | r > 0 = (saturated ((r + halfBase) * w), saturated r)
  | otherwise = (saturated ((r - halfBase) * w), saturated r)
  where
    r = 1000 * v / w
    halfBase = 1000 * wheelbase / 2
    epsilon = 0.0001

-- | Towards zero, within 16 bits.
saturated :: Double -> Int16
saturated x = fromInteger (max (-32768) (min 32767 (truncate x)))

-- | The word of all outputs; each command sends the whole of it.
newtype Outputs = Outputs Word16
  deriving (Eq, Show)

-- | All four power connectors on and both lights off, as the driver starts (kobuki_driver, command.hpp:
-- gp_out).
powerOn :: Outputs
powerOn = Outputs 0x00F0

-- | The outputs after a command; unchanged when it is no command to an output.
obeying :: Action -> Outputs -> Outputs
obeying a (Outputs o) = Outputs (withOutput serialTable a o)

-- | Identifier 12.
outputs :: Outputs -> ByteString
outputs (Outputs o) = packet (B.pack [12, 2] <> u16 o)

-- | The packet of a command that has one of its own: a sound.
ownPacket :: Action -> Maybe ByteString
ownPacket a = (\(ident, byte) -> packet (B.pack [ident, 1, byte])) <$> singleByte serialTable a

-- | Identifier 9: hardware, firmware and serial number (flags 1, 2, 8).
requestVersions :: ByteString
requestVersions = packet (B.pack [9, 2] <> u16 0x000B)

u16 :: Word16 -> ByteString
u16 n = B.pack [fromIntegral (n .&. 0xFF), fromIntegral (n `shiftR` 8) :: Word8]
