{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Codec
-- Description : JSON form of the messages of a channel, table-driven, in both directions.
--
-- The one codec of all links: the pipe to the simulator, rosbridge, and ROS 1, whose messages become JSON first
-- ("Rosy.Robots.DynamicMessage"). Pure. Integers leave without a decimal point, because real rosbridge servers refuse @1.0@ for one.
--
-- > decodeFields places (encodeFields places [] fields) = fields
module Rosy.Codec
  ( -- * Topics
    Route (..),
    routes,
    commandRoutes,
    sensorRoutes,
    sensorTopics,
    readMessages,
    readAction,
    routeFor,

    -- * Messages
    decodeFields,
    decodeLeaf,
    scaled,
    encodeFields,
  )
where

import Control.Monad ((>=>))
import Data.Aeson (Value (Array, Bool, Object, String))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Encoding as Encoding
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Bits (testBit, (.&.))
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Base64 as Base64
import Data.Either (partitionEithers)
import Data.List (find, sortOn)
import Data.List.NonEmpty (NonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (fromMaybe)
import Data.Scientific (floatingOrInteger, toRealFloat)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Vector as Vector
import Rosy.Channel (Action (..), Channel (..), Field (Number, Whole), Kind (..), Message (..))
import qualified Rosy.Channel as Channel
import Rosy.Profile

-- | A channel with the names that it has on one robot.
data Route = Route
  { routeChannel :: Channel,
    routeTopic :: Text,
    routeType :: Text,
    routeLatched :: Bool,
    -- | The fields of a message, or which of them does not fit.
    decoded :: Value -> Either String [Field],
    -- | The message with these fields.
    encode :: [Field] -> Encoding.Encoding
  }

-- | The channels of a robot with the variables of a profile.
routes :: Robot -> Variables -> [Route]
routes robot variables = map route (robotMappings robot)
  where
    route m =
      Route
        { routeChannel = mappingChannel m,
          routeTopic = expand variables (topicPattern m),
          routeType = expand variables (typePattern m),
          routeLatched = mappingLatched m,
          decoded = decodeFields (mappingPlaces m) >=> valid (mappingChannel m),
          encode = encodeFields (mappingPlaces m) (mappingConstants m)
        }
    valid c fields = case channelShow c fields of
      Just _ -> Right fields
      Nothing -> Left ("a number of " ++ channelName c ++ " is out of range")

-- | What programs send.
commandRoutes :: [Route] -> [Route]
commandRoutes = filter ((== CommandChannel) . channelKind . routeChannel)

-- | What programs take.
sensorRoutes :: [Route] -> [Route]
sensorRoutes = filter ((/= CommandChannel) . channelKind . routeChannel)

-- | The topics of the sensors, each with the routes of all channels that it carries.
sensorTopics :: [Route] -> [NonEmpty Route]
sensorTopics known = NonEmpty.groupAllWith routeTopic (sensorRoutes known)

-- | The sensor messages in a message on a topic, in the order of the routes: one for each channel whose fields it has. Why there is
-- none, if there is none.
readMessages :: [Route] -> Text -> Value -> Either String [Message]
readMessages known topic message = case partitionEithers [Message (routeChannel r) <$> decoded r message | r <- sensorRoutes known, routeTopic r == topic] of
  ([], []) -> Left ("unknown topic " ++ show topic)
  (why : _, []) -> Left why
  (_, found) -> Right found

-- | The command on a topic.
readAction :: [Route] -> Text -> Value -> Either String Action
readAction known topic message = case find ((== topic) . routeTopic) (commandRoutes known) of
  Just r -> Action (routeChannel r) <$> decoded r message
  Nothing -> Left ("unknown topic " ++ show topic)

-- | The route of a channel; none when the robot does not have it.
routeFor :: [Route] -> Channel -> Maybe Route
routeFor known c = find ((== c) . routeChannel) known

-- | The fields of a message, or which of them does not fit.
decodeFields :: [Place] -> Value -> Either String [Field]
decodeFields places message = mapM place places
  where
    place p = case p of
      At path leaf -> at path message >>= maybe (Left (spelled path ++ " does not fit")) Right . decodeLeaf leaf
      Yaw path -> do
        z <- number (path ++ [Key "z"])
        w <- number (path ++ [Key "w"])
        pure (Number (wrapped (2 * atan2 z w)))
    number path = at path message >>= maybe (Left (spelled path ++ " is not a number")) Right . numberIn
    -- To (-pi, pi].
    wrapped a
      | a > pi = a - 2 * pi
      | a <= negate pi = a + 2 * pi
      | otherwise = a

numberIn :: Value -> Maybe Double
numberIn v = case v of
  Aeson.Number n -> Just (toRealFloat n)
  _ -> Nothing

wholeIn :: Value -> Maybe Int
wholeIn v = case v of
  Aeson.Number n | Right i <- (floatingOrInteger n :: Either Double Integer), abs i < 2 ^ (53 :: Int) -> Just (fromInteger i)
  _ -> Nothing

-- | A number of a message in the unit of the field. Dividing by ten, unlike multiplying by 0.1, gives the number that people write.
scaled :: Double -> Double -> Double
scaled factor x = if factor < 1 then x / recip factor else x * factor

-- | The field in a number, a truth or a text; nothing when it does not fit.
decodeLeaf :: Leaf -> Value -> Maybe Field
decodeLeaf leaf v = case leaf of
  ANumber factor -> Number . scaled factor <$> numberIn v
  AWhole -> Whole <$> wholeIn v
  ATruth -> case v of
    Bool b -> Just (Whole (fromEnum b))
    _ -> Whole <$> (wholeIn v >>= \n -> if n == 0 || n == 1 then Just n else Nothing)
  AText -> case v of
    String t -> Just (Channel.Text (Text.unpack t))
    _ -> Nothing
  ABit b -> (\n -> Whole (fromEnum (testBit n b))) <$> wholeIn v
  TheFirstOf flags -> (\n -> Whole (fromMaybe 0 (find (\f -> n .&. f /= 0) flags))) <$> wholeIn v

-- | What is at a path. An array of bytes may be a text in base 64, as rosbridge servers write it.
at :: [Step] -> Value -> Either String Value
at path = go path
  where
    go [] v = Right v
    go (Key k : rest) (Object o) | Just v <- KeyMap.lookup (Key.fromText k) o = go rest v
    go (Index i : rest) (Array a) | Just v <- a Vector.!? i = go rest v
    go (Index i : rest) (String t)
      | Right bytes <- Base64.decode (Text.encodeUtf8 t), i < ByteString.length bytes = go rest (Aeson.Number (fromIntegral (ByteString.index bytes i)))
    go _ _ = Left (spelled path ++ " is missing")

spelled :: [Step] -> String
spelled path = show (Text.unpack (Text.intercalate "." (map step path)))
  where
    step (Key k) = k
    step (Index i) = Text.pack (show i)

-- | A message as a tree of what each part is made from.
data Tree = Leaf ([Field] -> Encoding.Encoding) | Branch [(Step, Tree)]

-- | The message with these fields, and with the constants in its other fields. Partial application prepares the message.
encodeFields :: [Place] -> [([Step], Double)] -> [Field] -> Encoding.Encoding
encodeFields places constants = encoded (foldl grown (Branch []) (concat (zipWith leaves [0 ..] places) ++ [(path, const (Encoding.double x)) | (path, x) <- constants]))
  where
    leaves i (At path leaf) = [(path, encodeLeaf leaf . (!! i))]
    leaves i (Yaw path) = [(path ++ [Key "z"], half sin . (!! i)), (path ++ [Key "w"], half cos . (!! i))]
    half f field = case field of
      Number a -> Encoding.double (f (a / 2))
      _ -> Encoding.null_

grown :: Tree -> ([Step], [Field] -> Encoding.Encoding) -> Tree
grown _ ([], leaf) = Leaf leaf
grown tree (step : rest, leaf) = Branch (insert (branches tree))
  where
    branches (Branch bs) = bs
    branches (Leaf _) = []
    insert [] = [(step, grown (Branch []) (rest, leaf))]
    insert ((s, t) : more)
      | s == step = (s, grown t (rest, leaf)) : more
      | otherwise = (s, t) : insert more

encoded :: Tree -> [Field] -> Encoding.Encoding
encoded (Leaf f) = f
encoded (Branch bs) = case bs of
  (Index _, _) : _ -> let items = [encoded t | (_, t) <- sortOn fst [(i, t) | (Index i, t) <- bs]] in \fields -> Encoding.list ($ fields) items
  _ -> let items = [(Key.fromText k, encoded t) | (Key k, t) <- bs] in \fields -> Encoding.pairs (foldMap (\(k, f) -> Encoding.pair k (f fields)) items)

encodeLeaf :: Leaf -> Field -> Encoding.Encoding
encodeLeaf leaf field = case field of
  Number x | ANumber factor <- leaf -> if factor == 1 then Encoding.double x else Encoding.int (round (x / factor))
  Number x -> Encoding.double x
  Whole n | ATruth <- leaf -> Encoding.bool (n /= 0)
  Whole n -> Encoding.int n
  Channel.Text t -> Encoding.string (map valid t)
  Channel.Structure v -> Encoding.value v
  where
    -- Half a pair of surrogates, which Haskell lets stand in a text, cannot be written in UTF-8.
    valid c = if c >= '\xD800' && c <= '\xDFFF' then '\xFFFD' else c
