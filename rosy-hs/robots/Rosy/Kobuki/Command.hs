-- |
-- Module      : Rosy.Kobuki.Command
-- Description : What the base is told in a packet.
--
-- In: speeds, lights, sounds. Out: the bytes for the serial line. Identifiers and lengths are those of
-- kobuki_driver's "Protocol Specification", Command Packets.
module Rosy.Kobuki.Command
  ( -- * Moving
    baseControl,
    wheelCommand,
    wheelbase,

    -- * Lights and power
    Outputs,
    powerOn,
    withLed1,
    withLed2,
    outputs,

    -- * The rest
    soundSequence,
    requestVersions,
  )
where

import Data.Bits (complement, shiftL, shiftR, (.&.), (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import Data.Int (Int16)
import Data.Word (Word16, Word8)
import Rosy.Kobuki.Frame (packet)
import Rosy.Robot (LedColor (..), Sound)

-- | Metres between the wheels (kobuki_driver, diff_drive.cpp: bias).
wheelbase :: Double
wheelbase = 0.23

-- | Identifier 1: a speed in m/s and a turn in rad/s.
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

withLed1, withLed2 :: LedColor -> Outputs -> Outputs
withLed1 = withLed 8
withLed2 = withLed 10

-- | Two bits per light, red and green; both are orange.
withLed :: Int -> LedColor -> Outputs -> Outputs
withLed bit colour (Outputs o) = Outputs ((o .&. complement (3 `shiftL` bit)) .|. (bits `shiftL` bit))
  where
    bits = case colour of
      Black -> 0
      Red -> 1
      Green -> 2
      Orange -> 3

-- | Identifier 12.
outputs :: Outputs -> ByteString
outputs (Outputs o) = packet (B.pack [12, 2] <> u16 o)

-- | Identifier 4: the seven sounds are numbered as 'Sound' lists them.
soundSequence :: Sound -> ByteString
soundSequence s = packet (B.pack [4, 1, fromIntegral (fromEnum s)])

-- | Identifier 9: hardware, firmware and serial number (flags 1, 2, 8).
requestVersions :: ByteString
requestVersions = packet (B.pack [9, 2] <> u16 0x000B)

u16 :: Word16 -> ByteString
u16 n = B.pack [fromIntegral (n .&. 0xFF), fromIntegral (n `shiftR` 8) :: Word8]
