{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Robots.RosbridgeCodec
-- Description : Codec of rosbridge v2 frames.
--
-- In: frames and commands. Out: messages and frames. Pure; the operations are rosbridge v2's. Servers differ, so
-- types are always sent (a server that does not know the topic yet would stay silent otherwise), the type of velocities is asked, integers have no
-- decimal point (@1.0@ for a uint8 is refused), all fields are there, and what cannot be understood is left out.
module Rosy.Robots.RosbridgeCodec
  ( -- * Frames of a client
    subscribeFrames,
    renewalFrames,
    ownRenewalFrames,
    advertiseFrames,
    topicFrames,
    encodeCommand,
    stopBytes,

    -- * Frames of a server
    Frame (..),
    decodeFrame,

    -- * The type of the velocity topic
    VelocityTypes,
    velocityQuestions,
    velocityRoute,
    strangeVelocity,
    stampedRoute,
    velocityAt,
  )
where

import Control.Applicative ((<|>))
import Data.Aeson (Value (..), object, withObject, (.:), (.=))
import qualified Data.Aeson as Aeson
import Data.Aeson.Encoding (Encoding, encodingToLazyByteString, integer, pair, pairs, text)
import Data.Aeson.Types (parseMaybe)
import Data.Bifunctor (first)
import Data.Bits ((.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as L
import Data.Function (on)
import Data.List (nubBy)
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as T
import Rosy.Channel (Action, Message)
import Rosy.Codec
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Profile (Delivery (..))
import Rosy.Request (callPrefix, isReply, pattern ReplyMessage, pattern RequestAction)
import Rosy.Robot (Velocity (..), pattern VelocityCommand)
import Rosy.Robots.JsonOfServers (readJson)
import Rosy.Robots.UnreadableMessages (Unreadable (..))
import Rosy.Sentence
import Rosy.Topic (absolute, pattern OpenAction, pattern OpenMessage)

-- | Announces the topics of commands. Lights are latched: what is published right after @advertise@ is lost
-- while the server connects to the base.
advertiseFrames :: [Route] -> [L.ByteString]
advertiseFrames known = map advertise (nubBy ((==) `on` routeTopic) (filter ((/= Called) . routeDelivery) (commandRoutes known)))
  where
    advertise r = Aeson.encode (object ["op" .= ("advertise" :: Text), "topic" .= routeTopic r, "type" .= routeType r, "latch" .= routeLatched r])

-- | Subscribes to the topics of sensors.
subscribeFrames :: [Route] -> [L.ByteString]
subscribeFrames = map (subscribeFrame . NonEmpty.head) . sensorTopics

subscribeFrame :: Route -> L.ByteString
subscribeFrame r = Aeson.encode (object ["op" .= ("subscribe" :: Text), "topic" .= routeTopic r, "type" .= routeType r])

-- | Subscribes anew. On ROS 2 a server chooses the quality of service when it subscribes, by the publishers that are there at that moment
-- (rosbridge_library, internal/subscribers.py): it never hears a best-effort publisher that comes later.
renewalFrames :: Route -> [L.ByteString]
renewalFrames r = [Aeson.encode (object ["op" .= ("unsubscribe" :: Text), "topic" .= routeTopic r]), subscribeFrame r]

-- | The same for a topic of the program's own that it takes.
ownRenewalFrames :: Topic -> [L.ByteString]
ownRenewalFrames t
  | topicUse t == Taken = Aeson.encode (object ["op" .= ("unsubscribe" :: Text), "topic" .= topicName t]) : topicFrames [t]
  | otherwise = []

-- | The frames that name a program's own topics.
topicFrames :: [Topic] -> [L.ByteString]
topicFrames topics = [Aeson.encode (object ["op" .= operation (topicUse t), "topic" .= topicName t, "type" .= topicType t]) | t <- topics]
  where
    operation use = case use of
      Sent -> "advertise" :: Text
      Taken -> "subscribe"

-- | The frame of a command at a time of the robot's clock, seconds, with what is held for the next; none for what the robot does not have.
encodeCommand :: [Route] -> Double -> Action -> Held -> (Maybe L.ByteString, Held)
encodeCommand _ _ (OpenAction name message) held = (Just (Aeson.encode (object ["op" .= ("publish" :: Text), "topic" .= name, "msg" .= message])), held)
encodeCommand _ _ (RequestAction frame) held = (Just (Aeson.encode frame), held)
encodeCommand known time a held = first (fmap frame) (commandMessage known a held)
  where
    frame (r, message) = encodingToLazyByteString . pairs $ case routeDelivery r of
      Called -> pair "op" (text "call_service") <> pair "service" (text (routeTopic r)) <> pair "type" (text (routeType r)) <> pair "args" message
      _ -> pair "op" (text "publish") <> pair "topic" (text (routeTopic r)) <> pair "msg" (velocityAt r time message)

-- | Whether its messages are velocities with a time.
isStamped :: Route -> Bool
isStamped r = typeName (routeType r) == "TwistStamped"

-- | The message of a route at a time of the robot's clock, seconds: that of velocities with a time says when it is.
velocityAt :: Route -> Double -> Encoding -> Encoding
velocityAt r time message
  | isStamped r = stamped (isRos2Type (routeType r)) time message
  | otherwise = message

-- | @geometry_msgs/msg/Twist@, not @geometry_msgs/Twist@.
isRos2Type :: Text -> Bool
isRos2Type = ("/msg/" `T.isInfixOf`)

-- | The last part of a type.
typeName :: Text -> Text
typeName = T.takeWhileEnd (/= '/')

-- | A geometry_msgs/Twist as a geometry_msgs/TwistStamped, in the frame of the base (REP 105).
stamped :: Bool -> Double -> Encoding -> Encoding
stamped ros2 time twist = pairs (pair "header" (pairs (pair "stamp" stamp <> pair "frame_id" (text "base_link"))) <> pair "twist" twist)
  where
    stamp = pairs (pair (if ros2 then "sec" else "secs") (integer whole) <> pair (if ros2 then "nanosec" else "nsecs") (integer (floor ((time - fromInteger whole) * 1e9))))
    whole = floor time

-- | The route of velocities for a base that takes them with a time.
stampedRoute :: Route -> Route
stampedRoute r
  | typeName (routeType r) == "Twist" = r {routeType = routeType r <> "Stamped"}
  | otherwise = r

-- | The types of topics as a server has answered; an empty one for a topic that no node has, none where it could not be asked.
type VelocityTypes = Map.Map Text (Maybe Text)

-- | Asks which type the topic of velocities has, and its sibling for velocities with a time (@cmd_vel_stamped@ of a Create 3 with firmware I.0.0).
velocityQuestions :: Route -> [(Text, L.ByteString)]
velocityQuestions r = [(topic, question topic) | topic <- [routeTopic r, sibling r]]
  where
    question topic = Aeson.encode (object ["op" .= ("call_service" :: Text), "id" .= (questionPrefix <> topic), "service" .= ("/rosapi/topic_type" :: Text), "args" .= object ["topic" .= topic]])

sibling :: Route -> Text
sibling r = routeTopic r <> "_stamped"

-- | Before the topic in the identifier of a question.
questionPrefix :: Text
questionPrefix = "type of "

-- | A base takes velocities of another type on this topic.
strangeVelocity :: Text -> Text -> Sentence
strangeVelocity topic kind = trWith "its velocities on {topic} are of the type {type}, which Rosy does not send" ["topic" =: topic, "type" =: kind]

-- | The route of velocities by the answers: none while no node has such a topic, or the type, if velocities of it are unknown here.
velocityRoute :: VelocityTypes -> Route -> Either Text (Maybe Route)
velocityRoute types r = case typeOf (routeTopic r) of
  Just kind
    | typeName kind == "Twist" -> Right (Just r)
    | typeName kind == "TwistStamped" -> Right (Just (stampedRoute r))
    | otherwise -> Left kind
  Nothing
    | fmap typeName (typeOf (sibling r)) == Just "TwistStamped" -> Right (Just ((stampedRoute r) {routeTopic = sibling r}))
    | otherwise -> Right Nothing
  where
    typeOf topic = case Map.lookup topic types of
      Just (Just kind) | not (T.null kind) -> Just kind
      _ -> Nothing

-- | The bytes of a frame of WebSocket (RFC 6455, 5.2) that tells the base to stand, for a process that has nothing else; none when the robot has no wheels. Its
-- mask is zero.
stopBytes :: [Route] -> Maybe ByteString
stopBytes known = L.toStrict . Builder.toLazyByteString . webSocketFrame <$> fst (encodeCommand known 0 (VelocityCommand (Velocity 0 0)) nothingHeld)
  where
    webSocketFrame payload = Builder.word8 0x81 <> Builder.word8 (0x80 .|. 126) <> Builder.word16BE (fromIntegral (L.length payload)) <> Builder.word32BE 0 <> Builder.lazyByteString payload

-- | What is in a frame.
data Frame = Frame
  { -- | The robot's messages, and the one on a topic of the program's own.
    frameMessages :: [Message],
    -- | What the server says that is wrong, in its own words, which have no translation: a @status@ of an error or a warning (rosbridge v2.0 Protocol
    -- Specification, 3.2.2), or a call that failed (3.3.9).
    frameComplaint :: Maybe Sentence,
    -- | Why it has none of the messages that it should have.
    frameUnreadable :: Maybe Unreadable,
    -- | The answer to a question of 'velocityQuestions': the topic and its type.
    frameType :: Maybe (Text, Maybe Text),
    -- | The topic of a message.
    frameTopic :: Maybe Text,
    -- | The time in the header of a message, seconds; none when it is not set.
    frameStamp :: Maybe Double
  }
  deriving (Eq, Show)

-- | The content of a frame. The topics of the program's own that are taken are given by name. Other operations and topics have none.
decodeFrame :: [Route] -> [String] -> L.ByteString -> Frame
decodeFrame known taken bytes = case readJson bytes of
  Left why -> nothing {frameUnreadable = Just (Unreadable "" (T.pack why))}
  Right (Object o) -> case parseMaybe (.: "op") o of
    Just ("publish" :: Text)
      | Just topic <- parseMaybe (.: "topic") o,
        Just message <- parseMaybe (.: "msg") o ->
        (published (T.unpack topic) message) {frameTopic = Just (T.pack (absolute (T.unpack topic))), frameStamp = stampIn message}
    Just "publish" -> nothing {frameUnreadable = Just (Unreadable "" "a message without a topic or content")}
    Just "status" | parseMaybe (.: "level") o `elem` map Just ["error", "warning" :: Text] -> nothing {frameComplaint = verbatim <$> parseMaybe (.: "msg") o}
    Just "service_response" | Just (Just topic) <- T.stripPrefix questionPrefix <$> parseMaybe (.: "id") o -> nothing {frameType = Just (topic, answered o)}
    Just op | isReply op, Just ident <- parseMaybe (.: "id") o, callPrefix `T.isPrefixOf` ident -> nothing {frameMessages = [ReplyMessage (Object o)]}
    Just "service_response" | parseMaybe (.: "result") o == Just False -> nothing {frameComplaint = failed (parseMaybe (.: "values") o) <$> parseMaybe (.: "service") o}
    Just _ -> nothing
    Nothing -> strange
  Right _ -> strange
  where
    nothing = Frame [] Nothing Nothing Nothing Nothing Nothing
    answered o
      | parseMaybe (.: "result") o == Just False = Nothing
      | otherwise = parseMaybe (\x -> x .: "values" >>= (.: "type")) o
    strange = nothing {frameUnreadable = Just (Unreadable "" "no operation")}
    -- Servers tell a topic as it was subscribed; some drop the slash.
    published topic message
      | T.pack name `elem` map routeTopic (sensorRoutes known) = either (\why -> nothing {frameMessages = own, frameUnreadable = Just (Unreadable (T.pack name) (T.pack why))}) (\found -> nothing {frameMessages = found ++ own}) (readMessages known (T.pack name) message)
      | otherwise = nothing {frameMessages = own}
      where
        name = absolute topic
        own = [OpenMessage name message | name `elem` taken]
    failed why service = case why of
      Just text' -> trWith "the service {service} failed: {why}" ["service" =: service, "why" =: text']
      Nothing -> trWith "the service {service} failed" ["service" =: service]

-- | The time in a message's header, as either ROS writes it.
stampIn :: Value -> Maybe Double
stampIn message = do
  stamp <- parseMaybe (withObject "a message" (.: "header")) message >>= parseMaybe (.: "stamp")
  time <- parseMaybe (ticks "sec" "nanosec") stamp <|> parseMaybe (ticks "secs" "nsecs") stamp
  if time > 0 then Just time else Nothing
  where
    ticks s n o = (\whole part -> whole + part / 1e9 :: Double) <$> o .: s <*> o .: n
