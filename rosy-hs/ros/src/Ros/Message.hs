-- |
-- Module      : Ros.Message
-- Description : What a message is, and how it looks on the wire.
--
-- A message knows its ROS name, the MD5 sum by which nodes agree on its layout, and how to become
-- bytes: fields in order, packed, little-endian whatever the machine
-- (<http://wiki.ros.org/ROS/Connection%20Header>, genpy's @generator.py@). The modules made by
-- @rosy-messages@ import this one only; a program imports it to name the classes.
module Ros.Message
  ( -- * What it is
    Message (..),
    Default (..),
    RosBinary (..),
    ROSTime,
    ROSDuration,

    -- * Using one
    encode,
    decode,
    DecodeError (..),
    toSeconds,
    fromSeconds,

    -- * For generated code
    Count (..),
    putBytes,
    getBytes,
    putNumbers,
    getNumbers,
    defNumbers,
    putList,
    getList,
    defList,
    Vector,
    Int8,
    Int16,
    Int32,
    Int64,
    Word8,
    Word16,
    Word32,
    Word64,
  )
where

import Control.Monad (replicateM)
import Data.Binary.Get hiding (getBytes)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import Data.ByteString.Builder
import Data.ByteString.Internal (fromForeignPtr, toForeignPtr)
import qualified Data.ByteString.Lazy as L
import Data.Int (Int16, Int32, Int64, Int8)
import Data.Proxy (Proxy)
import qualified Data.Text as T
import qualified Data.Text.Encoding as T
import qualified Data.Text.Encoding.Error as T
import Data.Vector.Storable (Storable, Vector)
import qualified Data.Vector.Storable as V
import Data.Word (Word16, Word32, Word64, Word8)

-- | A type that can be sent over a topic.
class (RosBinary a, Default a) => Message a where
  -- | @geometry_msgs/Twist@
  messageType :: Proxy a -> String

  messageMd5 :: Proxy a -> String

  -- | The text of the definition and of all it nests.
  messageDefinition :: Proxy a -> String

  -- | The message with this sequence number in its header, if it has a header.
  numbered :: Word32 -> a -> a
  numbered _ x = x

-- | The message that a @.msg@ file means before anyone fills it: zeros, empty arrays.
class Default a where
  def :: a

class RosBinary a where
  put :: a -> Builder
  get :: Get a

-- | Seconds and nanoseconds since 1970.
type ROSTime = (Word32, Word32)

-- | Seconds and nanoseconds; both carry the sign.
type ROSDuration = (Int32, Int32)

toSeconds :: ROSTime -> Double
toSeconds (s, n) = fromIntegral s + fromIntegral n * 1e-9

-- | Negative times become 1970: ROS has no others.
fromSeconds :: Double -> ROSTime
fromSeconds t = (fromIntegral (s + carry), fromIntegral n)
  where
    s = floor (max 0 t) :: Integer
    (carry, n) = (round ((max 0 t - fromIntegral s) * 1e9) :: Integer) `divMod` 1000000000

data DecodeError
  = -- | The bytes end before the message does, or say something impossible.
    Malformed String
  | -- | So many bytes were left over.
    LeftOver Int
  deriving (Eq, Show)

encode :: RosBinary a => a -> ByteString
encode = L.toStrict . toLazyByteString . put

decode :: RosBinary a => ByteString -> Either DecodeError a
decode bytes = case runGetOrFail get (L.fromStrict bytes) of
  Left (_, _, why) -> Left (Malformed why)
  Right (rest, _, x)
    | L.null rest -> Right x
    | otherwise -> Left (LeftOver (fromIntegral (L.length rest)))

-- | Whether an array carries its length.
data Count
  = -- | @uint8[]@: a 32 bit length goes first.
    Counted
  | -- | @float64[36]@: always so many; a shorter value is filled with zeros, a longer one is cut.
    Fixed Int

putCount :: Count -> Int -> Builder
putCount Counted n = word32LE (fromIntegral n)
putCount (Fixed _) _ = mempty

getCount :: Count -> Get Int
getCount Counted = fromIntegral <$> getWord32le
getCount (Fixed n) = pure n

-- | As 'putNumbers', without looking at each byte: a picture has a million.
putBytes :: Count -> Vector Word8 -> Builder
putBytes count v = putCount count (V.length v) <> byteString (fromForeignPtr start 0 size)
  where
    (start, size) = V.unsafeToForeignPtr0 (sized count v)

getBytes :: Count -> Get (Vector Word8)
getBytes count = do
  bytes <- getCount count >>= getByteString
  let (start, offset, size) = toForeignPtr (B.copy bytes) -- a copy, so that a small field does not keep a whole packet
  pure $! V.unsafeFromForeignPtr start offset size

putNumbers :: (Storable a, RosBinary a, Default a) => Count -> Vector a -> Builder
putNumbers count v = putCount count (V.length v) <> V.foldr (\x rest -> put x <> rest) mempty (sized count v)

sized :: (Storable a, Default a) => Count -> Vector a -> Vector a
sized Counted v = v
sized (Fixed n) v = if V.length v == n then v else V.take n v V.++ V.replicate (n - V.length v) def

-- | A length that the message cannot hold fails as soon as the bytes run out.
getNumbers :: (Storable a, RosBinary a) => Count -> Get (Vector a)
getNumbers count = do
  n <- getCount count
  V.fromListN n <$> replicateChecked n get

defNumbers :: (Storable a, Default a) => Count -> Vector a
defNumbers Counted = V.empty
defNumbers (Fixed n) = V.replicate n def

putList :: (RosBinary a, Default a) => Count -> [a] -> Builder
putList count xs = putCount count (length xs) <> foldMap put (exactly xs)
  where
    exactly = case count of
      Counted -> id
      Fixed n -> \x -> take n (x ++ repeat def)

getList :: RosBinary a => Count -> Get [a]
getList count = getCount count >>= \n -> replicateChecked n get

defList :: Default a => Count -> [a]
defList Counted = []
defList (Fixed n) = replicate n def

-- | 'replicateM' that does not believe a count of four billion: elements of no size stay few.
replicateChecked :: Int -> Get a -> Get [a]
replicateChecked n one
  | n <= 0 = pure []
  | otherwise = do
    before <- bytesRead
    x <- one
    after <- bytesRead
    if after == before && n > 65536
      then fail "an impossible number of empty elements"
      else (x :) <$> replicateM (n - 1) one

instance RosBinary Bool where
  put b = word8 (if b then 1 else 0)
  get = (/= 0) <$> getWord8

instance RosBinary Int8 where put = int8; get = getInt8

instance RosBinary Word8 where put = word8; get = getWord8

instance RosBinary Int16 where put = int16LE; get = getInt16le

instance RosBinary Word16 where put = word16LE; get = getWord16le

instance RosBinary Int32 where put = int32LE; get = getInt32le

instance RosBinary Word32 where put = word32LE; get = getWord32le

instance RosBinary Int64 where put = int64LE; get = getInt64le

instance RosBinary Word64 where put = word64LE; get = getWord64le

instance RosBinary Float where put = floatLE; get = getFloatle

instance RosBinary Double where put = doubleLE; get = getDoublele

-- | A string. UTF-8; bytes that are not become replacement characters.
instance a ~ Char => RosBinary [a] where
  put s = putCount Counted (B.length bytes) <> byteString bytes
    where
      bytes = T.encodeUtf8 (T.pack s)
  get = T.unpack . T.decodeUtf8With T.lenientDecode <$> (getCount Counted >>= getByteString)

-- | A time or a duration. Both parts are evaluated, so that a message keeps none of the bytes that it came from.
instance (RosBinary a, RosBinary b) => RosBinary (a, b) where
  put (x, y) = put x <> put y
  get = do
    x <- get
    y <- get
    x `seq` y `seq` pure (x, y)

instance Default Bool where def = False

instance Default Int8 where def = 0

instance Default Word8 where def = 0

instance Default Int16 where def = 0

instance Default Word16 where def = 0

instance Default Int32 where def = 0

instance Default Word32 where def = 0

instance Default Int64 where def = 0

instance Default Word64 where def = 0

instance Default Float where def = 0

instance Default Double where def = 0

instance Default [a] where def = []

instance (Default a, Default b) => Default (a, b) where def = (def, def)
