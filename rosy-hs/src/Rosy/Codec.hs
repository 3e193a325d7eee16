{-# LANGUAGE LambdaCase #-}
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
    routeLatched,
    commandTopics,
    readMessages,
    readAction,
    routeFor,

    -- * What is known of a robot
    Levels,
    noLevels,
    onlyChanges,
    Held,
    nothingHeld,
    commandMessage,

    -- * Messages
    decodeFields,
    decodeNumbers,
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
import qualified Data.ByteString.Builder as Builder
import Data.Either (partitionEithers)
import qualified Data.IntMap.Strict as IntMap
import Data.List (find, mapAccumL, sortOn)
import Data.List.NonEmpty (NonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Scientific (floatingOrInteger)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Vector as Vector
import Rosy.Channel (Action (..), Channel (..), Field (Number, Whole), Kind (..), Message (..))
import qualified Rosy.Channel as Channel
import Rosy.JsonNumber (finiteIn)
import Rosy.LaserScan
import Rosy.Profile
import Rosy.Value.DecimalDigits (showsDouble)

-- | A channel with the names that it has on one robot.
data Route = Route
  { routeChannel :: Channel,
    routeTopic :: Text,
    routeType :: Text,
    routeDelivery :: Delivery,
    -- | Whether every message says of all places what they are, so that only changes are events.
    routeHasLevels :: Bool,
    -- | The channels of a command's message, in the order of their fields, each with its fields at first; none when the message is the
    -- command's alone.
    routeShared :: [(Channel, [Field])],
    -- | The fields of the messages in a message, or which of them does not fit.
    decoded :: Value -> Either String [[Field]],
    -- | 'decodeNumbers' of a message that has one value.
    decodedNumbers :: [Double] -> Maybe [Field],
    -- | The message with these fields.
    encode :: [Field] -> Encoding.Encoding
  }

-- | Whether those who subscribe later get the last message as well.
routeLatched :: Route -> Bool
routeLatched r = routeDelivery r == Latched

-- | The channels of a robot with the variables of a profile.
routes :: Robot -> Variables -> [Route]
routes robot variables = map route mappings
  where
    mappings = map filled (robotMappings robot)
    filled m = m {topicPattern = expand variables (topicPattern m), typePattern = expand variables (typePattern m)}
    route m =
      Route
        { routeChannel = mappingChannel m,
          routeTopic = topicPattern m,
          routeType = typePattern m,
          routeDelivery = mappingDelivery m,
          routeHasLevels = not (null (mappingLevels m)),
          routeShared = [(mappingChannel o, fromMaybe [] (lookup (mappingChannel o) (robotHeld robot))) | length together > 1, o <- together],
          decoded = if null (mappingLevels m) then fmap pure . (decodeFields (mappingPlaces m) >=> valid (mappingChannel m)) else decodeLevels (mappingLevels m),
          decodedNumbers = if null (mappingLevels m) then decodeNumbers (mappingPlaces m) else const Nothing,
          encode = encodeFields (concatMap mappingPlaces together) (concatMap mappingConstants together)
        }
      where
        together = if isCommand m then [o | o <- mappings, isCommand o, topicPattern o == topicPattern m] else [m]
    isCommand = (== CommandChannel) . channelKind . mappingChannel
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
readMessages known topic message = case partitionEithers [map (Message (routeChannel r)) <$> decoded r message | r <- sensorRoutes known, routeTopic r == topic] of
  ([], []) -> Left ("unknown topic " ++ show topic)
  (why : _, []) -> Left why
  (_, found) -> Right (concat found)

-- | The topics that carry one command each.
commandTopics :: [Route] -> [Text]
commandTopics known = [routeTopic r | r <- commandRoutes known, null (routeShared r), routeDelivery r /= Called]

-- | The command on a topic that carries one.
readAction :: [Route] -> Text -> Value -> Either String Action
readAction known topic message = case find ((== topic) . routeTopic) (commandRoutes known) of
  Just r | topic `elem` commandTopics known -> Action (routeChannel r) . concat <$> decoded r message
  _ -> Left ("unknown topic " ++ show topic)

-- | The route of a channel; none when the robot does not have it.
routeFor :: [Route] -> Channel -> Maybe Route
routeFor known c = find ((== c) . routeChannel) known

-- | The places of channels with levels that are on: number of the channel, place.
newtype Levels = Levels (Set.Set (Int, Int))

-- | No place is on.
noLevels :: Levels
noLevels = Levels Set.empty

-- | The messages without those that repeat what a place was before, in order.
onlyChanges :: [Route] -> [Message] -> Levels -> ([Message], Levels)
onlyChanges known messages (Levels before) = (concat kept, Levels after)
  where
    (after, kept) = mapAccumL change before messages
    change on m = case m of
      Message c [Whole place, Whole level]
        | channelNumber c `elem` withLevels ->
          let key = (channelNumber c, place)
           in if (level /= 0) == Set.member key on then (on, []) else (if level /= 0 then Set.insert key on else Set.delete key on, [m])
      _ -> (on, [m])
    withLevels = [channelNumber (routeChannel r) | r <- known, routeHasLevels r]

-- | The last fields of each command whose message has other commands too, by the number of its channel.
newtype Held = Held (IntMap.IntMap [Field])

-- | No command was sent.
nothingHeld :: Held
nothingHeld = Held IntMap.empty

-- | The message of a command, with what the other commands in it were last; none for what the robot does not have.
commandMessage :: [Route] -> Action -> Held -> (Maybe (Route, Encoding.Encoding), Held)
commandMessage known (Action c fields) (Held before) = case routeFor (commandRoutes known) c of
  Nothing -> (Nothing, Held before)
  Just r
    | null (routeShared r) -> (Just (r, encode r fields), Held before)
    | otherwise ->
      let after = IntMap.insert (channelNumber c) fields before
       in (Just (r, encode r (concat [IntMap.findWithDefault atFirst (channelNumber o) after | (o, atFirst) <- routeShared r])), Held after)

-- | Each place and whether it is on, or what is missing in the message.
decodeLevels :: [Level] -> Value -> Either String [[Field]]
decodeLevels levels message = sequence [(\on -> [Whole place, Whole (fromEnum on)]) <$> level l | (place, l) <- zip [0 ..] levels]
  where
    level l = case l of
      IsSet path leaf -> at path message >>= maybe (Left (spelled path ++ " does not fit")) (Right . (== Whole 1)) . decodeLeaf leaf
      HasEntry path (kind, number) name isIn names ->
        at path message >>= \case
          Array entries -> Right (any (\e -> (at kind e >>= wholeAt) == Right (Just number) && maybe False ((== isIn) . (`elem` names)) (textAt name e)) entries)
          _ -> Left (spelled path ++ " is not a list")
    wholeAt = Right . wholeIn
    textAt path e = case at path e of
      Right (String t) -> Just t
      _ -> Nothing

-- | The fields of a message, or which of them does not fit.
decodeFields :: [Place] -> Value -> Either String [Field]
decodeFields places message = concat <$> mapM place places
  where
    place p = case p of
      NearestAhead within -> pure . Number <$> nearestAhead within message
      ScanRanges -> map Number . scanRanges <$> scanIn message
      At path leaf -> pure <$> fitting path leaf
      AtAll paths leaf -> pure <$> maybe (Left "there is no place") (`fitting` leaf) (listToMaybe paths)
      Yaw path -> do
        z <- number (path ++ [Key "z"])
        w <- number (path ++ [Key "w"])
        pure [heading z w]
    fitting path leaf = at path message >>= maybe (Left (spelled path ++ " does not fit")) Right . decodeLeaf leaf
    number path = at path message >>= maybe (Left (spelled path ++ " is not a number")) Right . finiteIn

-- | The fields in the numbers of a message, which are in the order of its places; nothing when a place holds something else.
decodeNumbers :: [Place] -> [Double] -> Maybe [Field]
decodeNumbers places found = case (places, found) of
  ([], []) -> Just []
  (At _ (ANumber factor) : more, x : rest) -> (Number (scaled factor x) :) <$> decodeNumbers more rest
  (Yaw _ : more, z : w : rest) -> (heading z w :) <$> decodeNumbers more rest
  _ -> Nothing

-- | The angle about the vertical in a quaternion, in (-pi, pi].
heading :: Double -> Double -> Field
heading z w = Number (wrapped (2 * atan2 z w))
  where
    wrapped a
      | a > pi = a - 2 * pi
      | a <= negate pi = a + 2 * pi
      | otherwise = a

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
  ANumber factor -> Number . scaled factor <$> finiteIn v
  AWhole -> Whole <$> wholeIn v
  ATruth -> case v of
    Bool b -> Just (Whole (fromEnum b))
    _ -> Whole <$> (wholeIn v >>= \n -> if n == 0 || n == 1 then Just n else Nothing)
  AText -> case v of
    String t -> Just (Channel.Text (Text.unpack t))
    _ -> Nothing
  ABit b -> (\n -> Whole (fromEnum (testBit n b))) <$> wholeIn v
  TheFirstOf flags -> (\n -> Whole (fromMaybe 0 (find (\f -> n .&. f /= 0) flags))) <$> wholeIn v
  ACode codes -> Whole . fst <$> find ((== Just v) . Aeson.decodeStrict' . Text.encodeUtf8 . snd) codes

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
encodeFields :: [Place] -> [([Step], Text)] -> [Field] -> Encoding.Encoding
encodeFields places constants = encoded (foldl grown (Branch []) (concat (zipWith leaves [0 ..] places) ++ [(path, const (json x)) | (path, x) <- constants]))
  where
    leaves i (At path leaf) = [(path, encodeLeaf leaf . (!! i))]
    leaves i (AtAll paths leaf) = [(path, encodeLeaf leaf . (!! i)) | path <- paths]
    -- A scan of one beam.
    leaves i (NearestAhead _) =
      [([Key name], const (Encoding.double 0)) | name <- ["angle_min", "angle_increment", "range_min"]]
        ++ [(path, encodeLeaf (ANumber 1) . (!! i)) | path <- [[Key "range_max"], [Key "ranges", Index 0]]]
    leaves i ScanRanges = [([Key "ranges"], Encoding.list (encodeLeaf (ANumber 1)) . drop i)]
    leaves i (Yaw path) = [(path ++ [Key "z"], half sin . (!! i)), (path ++ [Key "w"], half cos . (!! i))]
    half f field = case field of
      Number a -> encodeNumber (f (a / 2))
      _ -> Encoding.null_

-- | What is JSON already.
json :: Text -> Encoding.Encoding
json = Encoding.unsafeToEncoding . Text.encodeUtf8Builder

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

-- | As 'Encoding.double', which takes 7 kB of memory for a number before bytestring 0.11.
encodeNumber :: Double -> Encoding.Encoding
encodeNumber x
  -- Of numbers that are endless or none this is not so.
  | x - x == 0 = Encoding.unsafeToEncoding (Builder.string7 (showsDouble 0 x ""))
  | otherwise = Encoding.double x

encodeLeaf :: Leaf -> Field -> Encoding.Encoding
encodeLeaf leaf field = case field of
  Number x | ANumber factor <- leaf -> if factor == 1 then encodeNumber x else Encoding.int (round (x / factor))
  Number x -> encodeNumber x
  Whole n | ACode codes <- leaf -> maybe Encoding.null_ json (lookup n codes)
  Whole n | ATruth <- leaf -> Encoding.bool (n /= 0)
  Whole n -> Encoding.int n
  Channel.Text t -> Encoding.string (map valid t)
  Channel.Structure v -> Encoding.value v
  where
    -- Half a pair of surrogates, which Haskell lets stand in a text, cannot be written in UTF-8.
    valid c = if c >= '\xD800' && c <= '\xDFFF' then '\xFFFD' else c
