{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Robots.RosbridgeCodec
-- Description : Codec of rosbridge v2 frames.
--
-- In: frames and commands. Out: messages and frames. Pure; the operations are rosbridge v2's. Servers differ, so
-- types are always sent (a server that does not know the topic yet would stay silent otherwise), integers have no
-- decimal point (@1.0@ for a uint8 is refused), all fields are there, and what cannot be understood is left out.
module Rosy.Robots.RosbridgeCodec
  ( openingFrames,
    topicFrames,
    encodeCommand,
    decodeFrame,
    complaintOf,
  )
where

import Data.Aeson (Value (..), object, (.:), (.=))
import qualified Data.Aeson as Aeson
import Data.Aeson.Encoding (encodingToLazyByteString, pair, pairs, text)
import Data.Aeson.Types (parseMaybe)
import Data.Bifunctor (first)
import qualified Data.ByteString.Lazy as L
import Data.Either (fromRight)
import Data.Function (on)
import Data.List (nubBy)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as T
import Rosy.Channel (Action, Message)
import Rosy.Codec
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Profile (Delivery (..))
import Rosy.Sentence
import Rosy.Topic (absolute, pattern OpenAction, pattern OpenMessage)

-- | The frames that are sent first. Lights are latched: what is published right after @advertise@ is lost
-- while the server connects to the base.
openingFrames :: [Route] -> [L.ByteString]
openingFrames known = map advertise (nubBy ((==) `on` routeTopic) (filter ((/= Called) . routeDelivery) (commandRoutes known))) ++ map (subscribe . NonEmpty.head) (sensorTopics known)
  where
    advertise r = Aeson.encode (object ["op" .= ("advertise" :: Text), "topic" .= routeTopic r, "type" .= routeType r, "latch" .= routeLatched r])
    subscribe r = Aeson.encode (object ["op" .= ("subscribe" :: Text), "topic" .= routeTopic r, "type" .= routeType r])

-- | The frames that name a program's own topics.
topicFrames :: [Topic] -> [L.ByteString]
topicFrames topics = [Aeson.encode (object ["op" .= operation (topicUse t), "topic" .= topicName t, "type" .= topicType t]) | t <- topics]
  where
    operation use = case use of
      Sent -> "advertise" :: Text
      Taken -> "subscribe"

-- | The frame of a command, with what is held for the next; none for what the robot does not have.
encodeCommand :: [Route] -> Action -> Held -> (Maybe L.ByteString, Held)
encodeCommand _ (OpenAction name message) held = (Just (Aeson.encode (object ["op" .= ("publish" :: Text), "topic" .= name, "msg" .= message])), held)
encodeCommand known a held = first (fmap frame) (commandMessage known a held)
  where
    frame (r, message) = encodingToLazyByteString . pairs $ case routeDelivery r of
      Called -> pair "op" (text "call_service") <> pair "service" (text (routeTopic r)) <> pair "type" (text (routeType r)) <> pair "args" message
      _ -> pair "op" (text "publish") <> pair "topic" (text (routeTopic r)) <> pair "msg" message

-- | What a server says that is wrong, in its own words, which have no translation: a @status@ of an error or a warning (rosbridge v2.0 Protocol Specification, 3.2.2), or a call that
-- failed (3.3.9).
complaintOf :: L.ByteString -> Maybe Sentence
complaintOf frame = do
  Object o <- Aeson.decode frame
  parseMaybe (.: "op") o >>= \case
    "status" | parseMaybe (.: "level") o `elem` map Just ["error", "warning" :: Text] -> verbatim <$> parseMaybe (.: "msg") o
    ("service_response" :: Text) | parseMaybe (.: "result") o == Just False -> do
      service <- parseMaybe (.: "service") o
      pure $ case parseMaybe (.: "values") o of
        Just why -> trWith "the service {service} failed: {why}" ["service" =: service, "why" =: why]
        Nothing -> trWith "the service {service} failed" ["service" =: service]
    _ -> Nothing

-- | The messages in a frame: the robot's, and one on a topic of the program's own. None for what is no message of the robot's: other operations, other topics,
-- odometry with a place that is no number (@null@).
decodeFrame :: [Route] -> [String] -> L.ByteString -> [Message]
decodeFrame known taken frame = fromMaybe [] $ do
  Object o <- Aeson.decode frame
  "publish" <- parseMaybe (.: "op") o :: Maybe Text
  topic <- parseMaybe (.: "topic") o
  msg <- parseMaybe (.: "msg") o
  -- Servers tell a topic as it was subscribed; some drop the slash.
  let name = absolute (T.unpack topic)
  pure (fromRight [] (readMessages known (T.pack name) msg) ++ [OpenMessage name msg | name `elem` taken])
