-- |
-- Module      : Rosy.Kobuki.Frame
-- Description : Packets on the base's serial line.
--
-- In: bytes in any pieces, with noise. Out: the payloads that are whole and whose checksum holds; and back.
-- A packet is @AA 55@, a length, so many bytes, and the exclusive or of length and bytes (kobuki_driver's
-- documentation, "Protocol Specification"). Nothing is escaped, so what looks like a packet and is none costs
-- its two first bytes and the search goes on behind them.
module Rosy.Kobuki.Frame
  ( Frames,
    noBytes,
    feed,
    packet,
    Feeding (..),
    minPayload,
    maxPayload,
  )
where

import Data.Bits (xor)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import Data.Word (Word8)

-- | What has come and is not decided yet.
newtype Frames = Frames ByteString
  deriving (Eq, Show)

noBytes :: Frames
noBytes = Frames B.empty

data Feeding = Feeding
  { payloads :: [ByteString],
    -- | Packets whose checksum did not hold.
    broken :: Int,
    left :: Frames
  }
  deriving (Eq, Show)

-- | The shortest payload that the driver takes, bytes (kobuki_driver, kobuki.cpp: packet_finder.configure).
minPayload :: Int
minPayload = 3

-- | The longest one: a length is one byte. The driver's own buffer holds 256 bytes with head and checksum.
maxPayload :: Int
maxPayload = 252

-- | The packets that these bytes complete.
--
-- > feed across any cut of the bytes gives the same payloads
feed :: Frames -> ByteString -> Feeding
feed (Frames old) new = go [] 0 (old <> new)
  where
    go found bad bytes = case B.uncons (B.dropWhile (/= 0xAA) bytes) of
      Nothing -> done found bad B.empty
      Just (_, rest) -> case B.uncons rest of
        Nothing -> done found bad (B.singleton 0xAA)
        Just (0x55, body) -> inPacket found bad (B.dropWhile (/= 0xAA) bytes) body
        Just _ -> go found bad rest
    inPacket found bad whole body = case B.uncons body of
      Nothing -> done found bad whole
      Just (n, content)
        | size < minPayload || size > maxPayload -> go found bad (B.drop 2 whole)
        | B.length content < size + 1 -> done found bad whole
        | checksum (B.cons n (B.take (size + 1) content)) == 0 -> go (B.take size content : found) bad (B.drop (size + 1) content)
        | otherwise -> go found (bad + 1) (B.drop 2 whole)
        where
          size = fromIntegral n
    done found bad rest = Feeding (reverse found) bad (Frames rest)

-- | The bytes of a payload on the line.
packet :: ByteString -> ByteString
packet payload = B.pack [0xAA, 0x55] <> body <> B.singleton (checksum body)
  where
    body = B.cons (fromIntegral (B.length payload)) payload

checksum :: ByteString -> Word8
checksum = B.foldl' xor 0
