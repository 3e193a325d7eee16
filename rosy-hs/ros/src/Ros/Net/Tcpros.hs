{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Ros.Net.Tcpros
-- Description : What two nodes say to each other before and while messages flow.
--
-- In: bytes in any pieces. Out: connection headers and message bodies, and back. No I/O. The format is
-- <http://wiki.ros.org/ROS/TCPROS>: a header is a length and fields, each a length and @name=value@; a
-- message is a length and a body; lengths are 32 bit little-endian.
module Ros.Net.Tcpros
  ( -- * Pieces with a length
    Frames,
    noBytes,
    feed,
    frame,
    maxFrame,
    TooLong (..),

    -- * Connection headers
    Fields,
    encodeFields,
    decodeFields,
    subscriberFields,
    publisherFields,
    errorFields,

    -- * Agreeing
    Offer (..),
    Disagreement (..),
    explainDisagreement,
    publisherAccepts,
    subscriberAccepts,
    callerAccepted,
  )
where

import Data.Bits (shiftL, (.|.))
import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as B
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import qualified Data.ByteString.Unsafe as B
import Data.Maybe (fromMaybe)
import qualified Data.Text as T
import qualified Data.Text.Encoding as T
import qualified Data.Text.Encoding.Error as T

-- | Bytes that have come and are no whole piece yet: newest first, with their number and the number at
-- which it is worth looking again. So a megabyte that comes in parts is put together once.
data Frames = Frames ![B.ByteString] !Int !Int

noBytes :: Frames
noBytes = Frames [] 0 4

-- | Roscpp refuses more than a billion bytes (roscpp, transport_publisher_link.cpp), and so do we.
maxFrame :: Int
maxFrame = 1000000000

-- | A length that cannot be meant.
newtype TooLong = TooLong Int
  deriving (Eq, Show)

-- | The pieces that these bytes complete, and what is left.
--
-- > feed across any cut of the bytes gives the same pieces
feed :: Int -> Frames -> B.ByteString -> Either TooLong ([B.ByteString], Frames)
feed limit (Frames old have needed) new
  | total < needed = Right ([], Frames (new : old) total needed)
  | otherwise = go [] (B.concat (reverse (new : old)))
  where
    total = have + B.length new
    go done bytes
      | B.length bytes < 4 = stop 4
      | n > limit = Left (TooLong n)
      | B.length bytes < 4 + n = stop (4 + n)
      | otherwise = go (B.take n (B.drop 4 bytes) : done) (B.drop (4 + n) bytes)
      where
        n = size bytes
        stop = Right . (,) (reverse done) . Frames [bytes] (B.length bytes)

size :: B.ByteString -> Int
size b = at 0 .|. at 1 `shiftL` 8 .|. at 2 `shiftL` 16 .|. at 3 `shiftL` 24
  where
    at i = fromIntegral (B.unsafeIndex b i) -- callers have looked that four bytes are there

-- | A length and the bytes.
frame :: B.Builder -> B.ByteString
frame body = L.toStrict (B.toLazyByteString (B.word32LE (fromIntegral (L.length whole)) <> B.lazyByteString whole))
  where
    whole = B.toLazyByteString body

type Fields = [(String, String)]

-- | The fields of a header, without the length of the whole.
encodeFields :: Fields -> B.Builder
encodeFields = foldMap (\(k, v) -> let f = T.encodeUtf8 (T.pack (k ++ "=" ++ v)) in B.word32LE (fromIntegral (B.length f)) <> B.byteString f)

decodeFields :: B.ByteString -> Either String Fields
decodeFields bytes
  | B.null bytes = Right []
  | B.length bytes < 4 || B.length bytes < 4 + size bytes = Left "a header field is cut off"
  | otherwise = case C.break (== '=') (B.take n (B.drop 4 bytes)) of
    (_, "") -> Left "a header field without '='"
    (k, v) -> ((chars k, chars (B.drop 1 v)) :) <$> decodeFields (B.drop (4 + n) bytes)
  where
    n = size bytes
    chars = T.unpack . T.decodeUtf8With T.lenientDecode

-- | What a node says of one of its topics.
data Offer = Offer
  { offerCaller :: String,
    offerTopic :: String,
    -- | @*@ for any
    offerType :: String,
    -- | @*@ for any
    offerMd5 :: String,
    offerDefinition :: String
  }
  deriving (Eq, Show)

subscriberFields :: Offer -> Fields
subscriberFields o =
  [ ("callerid", offerCaller o),
    ("topic", offerTopic o),
    ("type", offerType o),
    ("md5sum", offerMd5 o),
    ("message_definition", offerDefinition o),
    ("tcp_nodelay", "1")
  ]

publisherFields :: Bool -> Offer -> Fields
publisherFields latching o =
  [ ("callerid", offerCaller o),
    ("topic", offerTopic o),
    ("type", offerType o),
    ("md5sum", offerMd5 o),
    ("message_definition", offerDefinition o),
    ("latching", if latching then "1" else "0")
  ]

errorFields :: Disagreement -> Fields
errorFields d = [("error", explainDisagreement d)]

data Disagreement
  = -- | A header without this field.
    MissingField String
  | -- | The other side means something else: type and sum, theirs and ours.
    TypeClash (String, String) (String, String)
  | -- | Not a topic of this node.
    UnknownTopic String
  | -- | Not a service of this node.
    UnknownService String
  | -- | The other side refused, in its words.
    TheyRefuse String
  deriving (Eq, Show)

explainDisagreement :: Disagreement -> String
explainDisagreement d = case d of
  MissingField f -> "the connection header has no " ++ f
  TypeClash (t, m) (t', m') -> "the other node has " ++ t ++ "/" ++ m ++ " and this one has " ++ t' ++ "/" ++ m'
  UnknownTopic t -> t ++ " is not published here"
  UnknownService n -> n ++ " is not offered here"
  TheyRefuse why -> "the other node refused: " ++ why

-- | A publisher looks at a subscriber's header. A star agrees with everything.
publisherAccepts :: Offer -> Fields -> Either Disagreement ()
publisherAccepts ours theirs = do
  _ <- wanted "callerid" theirs
  m <- wanted "md5sum" theirs
  let t = fromMaybe "*" (lookup "type" theirs)
  agree (t, m) ours

-- | A subscriber looks at a publisher's header.
subscriberAccepts :: Offer -> Fields -> Either Disagreement ()
subscriberAccepts ours theirs = case lookup "error" theirs of
  Just why -> Left (TheyRefuse why)
  Nothing -> do
    m <- wanted "md5sum" theirs
    t <- wanted "type" theirs
    agree (t, m) ours

-- | A server looks at a caller's header, knowing its service's name, type and sum.
callerAccepted :: (String, String, String) -> Fields -> Either Disagreement ()
callerAccepted (name, kind, sum5) theirs = do
  _ <- wanted "callerid" theirs
  m <- wanted "md5sum" theirs
  agree (fromMaybe "*" (lookup "type" theirs), m) (Offer "" name kind sum5 "")

-- | The sum decides; names may differ when the layout is the same, as for rospy.
agree :: (String, String) -> Offer -> Either Disagreement ()
agree (t, m) ours
  | m == "*" || offerMd5 ours == "*" || m == offerMd5 ours = Right ()
  | otherwise = Left (TypeClash (t, m) (offerType ours, offerMd5 ours))

wanted :: String -> Fields -> Either Disagreement String
wanted f fields = maybe (Left (MissingField f)) Right (lookup f fields)
