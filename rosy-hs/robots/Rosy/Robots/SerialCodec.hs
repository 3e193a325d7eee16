-- |
-- Module      : Rosy.Robots.SerialCodec
-- Description : Channels in the packets of a serial line, table-driven.
--
-- In: the serial table of a robot ("Rosy.Robot.Known"), the parts of packets, and commands. Out: messages for changed values, and the
-- bytes and bits of commands. Pure. Numbers are little-endian.
module Rosy.Robots.SerialCodec
  ( -- * Parts of a packet
    Parts,
    readParts,

    -- * Sensors
    Reported,
    nothingReported,
    changes,

    -- * Commands
    withOutput,
    singleByte,
  )
where

import qualified Data.Aeson as Aeson
import Data.Bits (complement, countLeadingZeros, finiteBitSize, shiftL, testBit, (.&.), (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import Data.Int (Int16)
import qualified Data.IntMap.Strict as IntMap
import Data.List (mapAccumL)
import Data.Maybe (fromMaybe)
import Data.Word (Word16, Word8)
import Rosy.Channel
import Rosy.Codec (decodeLeaf)
import Rosy.Profile (Leaf, Serial (..), Width (..))

-- | The data of each part of a packet, by its identifier.
type Parts = [(Word8, ByteString)]

-- | The parts of a payload: identifier, length, data. A part that is cut off at the end is left out.
readParts :: ByteString -> Parts
readParts payload = case B.unpack (B.take 2 payload) of
  [ident, n]
    | B.length body >= fromIntegral n -> (ident, B.take (fromIntegral n) body) : readParts (B.drop (fromIntegral n) body)
    where
      body = B.drop 2 payload
  _ -> []

-- | The last fields of each channel that were reported, by its number; of 'Edges' one bit for each place.
newtype Reported = Reported (IntMap.IntMap [Field])

-- | Before the first packet: all events are off, no state is known.
nothingReported :: Reported
nothingReported = Reported IntMap.empty

-- | A message for each change since the last packet, in the order of the table. The first packet is compared with zeros for events, and is
-- a change of every state.
changes :: [(Channel, Serial)] -> Parts -> Reported -> ([Message], Reported)
changes table parts (Reported before) = (concat found, Reported after)
  where
    (after, found) = mapAccumL channelChanges before table
    channelChanges known (c, serial) = case current parts serial of
      Nothing -> (known, [])
      Just now -> (IntMap.insert (channelNumber c) now known, differences c serial now (IntMap.lookup (channelNumber c) known))
    differences c serial now old = case serial of
      Edges {} -> [Message c [Whole place, new] | (place, new, was) <- zip3 [0 ..] now (fromMaybe zeros old), new /= was]
      _
        | channelKind c == EventChannel, now == fromMaybe zeros old -> []
        | Just now == old -> []
        | otherwise -> [Message c now]
      where
        zeros = map (const (Whole 0)) now

-- | What the parts say of a channel.
current :: Parts -> Serial -> Maybe [Field]
current parts serial = case serial of
  Edges packet byte bits -> (\d -> [Whole (fromEnum (testBit d b)) | b <- bits]) <$> (inPart packet >>= (`byteAt` byte))
  Values packet places -> inPart packet >>= \d -> mapM (value d) places
  Output _ _ -> Nothing
  Command _ -> Nothing
  where
    inPart packet = lookup (fromIntegral packet) parts
    value d (byte, width, leaf) = numberAt d byte width >>= leafOf leaf

leafOf :: Leaf -> Int -> Maybe Field
leafOf leaf n = decodeLeaf leaf (Aeson.Number (fromIntegral n))

numberAt :: ByteString -> Int -> Width -> Maybe Int
numberAt d byte width = case width of
  U8 -> fromIntegral <$> byteAt d byte
  U16 -> fromIntegral <$> word
  I16 -> (\w -> fromIntegral (fromIntegral w :: Int16)) <$> word
  where
    word = (\low high -> fromIntegral low .|. (fromIntegral high `shiftL` 8)) <$> byteAt d byte <*> byteAt d (byte + 1) :: Maybe Word16

byteAt :: ByteString -> Int -> Maybe Word8
byteAt d i
  | i < B.length d = Just (B.index d i)
  | otherwise = Nothing

-- | The word of all outputs after a command; unchanged when the command is none of its bits.
withOutput :: [(Channel, Serial)] -> Action -> Word16 -> Word16
withOutput table (Action c fields) word = case (lookup c table, fields) of
  (Just (Output bit codes), [Whole code]) -> put bit codes code
  (Just (Output bit codes), [Whole place, Whole code]) -> put (bit + place * bitsOf codes) codes code
  _ -> word
  where
    put bit codes code = case drop code codes of
      bits : _ -> (word .&. complement (((1 `shiftL` bitsOf codes) - 1) `shiftL` bit)) .|. (fromIntegral bits `shiftL` bit)
      [] -> word
    -- The width of the largest code.
    bitsOf codes = finiteBitSize (0 :: Int) - countLeadingZeros (maximum (0 : codes))

-- | The identifier and the byte of a command that is a packet of its own.
singleByte :: [(Channel, Serial)] -> Action -> Maybe (Word8, Word8)
singleByte table (Action c fields) = case (lookup c table, fields) of
  (Just (Command packet), [Whole code]) -> Just (fromIntegral packet, fromIntegral code)
  _ -> Nothing
