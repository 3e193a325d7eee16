{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.Rosbridge
-- Description : What is said to a rosbridge server, and what its frames mean.
--
-- In: frames and commands. Out: messages and frames. Pure; the operations are rosbridge v2's. Servers differ, so
-- types are always sent (a server that does not know the topic yet would stay silent otherwise), integers have no
-- decimal point (@1.0@ for a uint8 is refused), all fields are there, and what cannot be understood is left out.
module Rosy.Robots.Rosbridge
  ( greeting,
    command,
    understand,
  )
where

import Data.Aeson (Value (..), object, (.:), (.=))
import qualified Data.Aeson as Aeson
import Data.Aeson.Encoding (Encoding, double, encodingToLazyByteString, int, pair, pairs, text)
import Data.Aeson.Types (parseMaybe)
import qualified Data.ByteString.Lazy as L
import Data.Text (Text)
import qualified Data.Text as T
import Rosy.Core (Action (..), Message)
import Rosy.Robots.Target (Profile (..))
import Rosy.Wire (sensorMessage)

-- | The frames that open the conversation. Lights are latched: what is published right after @advertise@ is lost
-- while the server connects to the base.
greeting :: Profile -> [L.ByteString]
greeting p = map advertise (commandTopics p) ++ map subscribe (sensorTopics p)
  where
    advertise (topic, type', latch) = Aeson.encode (object ["op" .= ("advertise" :: Text), "topic" .= topic, "type" .= type', "latch" .= latch])
    subscribe (topic, type', _) = Aeson.encode (object ["op" .= ("subscribe" :: Text), "topic" .= topic, "type" .= type'])

-- | Topic, type, latched.
commandTopics :: Profile -> [(Text, Text, Bool)]
commandTopics p =
  [ (T.pack (velocityTopic p), kindIn "geometry_msgs" p "Twist", False),
    (at p "/commands/led1", kind p "Led", True),
    (at p "/commands/led2", kind p "Led", True),
    (at p "/commands/sound", kind p "Sound", False),
    ("/rosy/say", kindIn "std_msgs" p "String", False)
  ]

-- | Here topic and type, and by which name "Rosy.Wire" knows the topic.
sensorTopics :: Profile -> [(Text, Text, Text)]
sensorTopics p =
  [(at p ("/events/" <> e), kind p k, "/mobile_base/events/" <> e) | (e, k) <- events]
    ++ [(T.pack (odometryTopic p), kindIn "nav_msgs" p "Odometry", "/odom")]
  where
    events =
      [ ("button", "ButtonEvent"),
        ("bumper", "BumperEvent"),
        ("cliff", "CliffEvent"),
        ("wheel_drop", "WheelDropEvent"),
        ("robot_state", "RobotStateEvent")
      ]

at :: Profile -> Text -> Text
at p t = T.pack (prefix p) <> t

kind :: Profile -> Text -> Text
kind p = kindIn (T.pack (messagePackage p)) p

kindIn :: Text -> Profile -> Text -> Text
kindIn package p name = package <> (if isRos2 p then "/msg/" else "/") <> name

-- | The frame of a command.
command :: Profile -> Action -> L.ByteString
command p a = case a of
  SetVelocity v w -> publish (T.pack (velocityTopic p)) (pairs (pair "linear" (vector v 0 0) <> pair "angular" (vector 0 0 w)))
  SetLed1 c -> publish (at p "/commands/led1") (value (fromEnum c))
  SetLed2 c -> publish (at p "/commands/led2") (value (fromEnum c))
  PlaySound s -> publish (at p "/commands/sound") (value (fromEnum s))
  SayText s -> publish "/rosy/say" (pairs (pair "data" (text (T.pack s))))
  where
    publish :: Text -> Encoding -> L.ByteString
    publish topic msg = encodingToLazyByteString (pairs (pair "op" (text "publish") <> pair "topic" (text topic) <> pair "msg" msg))
    vector x y z = pairs (pair "x" (double x) <> pair "y" (double y) <> pair "z" (double z))
    value n = pairs (pair "value" (int n))

-- | The message in a frame. Nothing for what is no message of the robot's: other operations, other topics,
-- odometry with a place that is no number (@null@).
understand :: Profile -> L.ByteString -> Maybe Message
understand p frame = do
  Object o <- Aeson.decode frame
  "publish" <- parseMaybe (.: "op") o :: Maybe Text
  topic <- parseMaybe (.: "topic") o
  (_, _, ours) <- lookup3 (absolute topic) (sensorTopics p)
  msg <- parseMaybe (.: "msg") o
  parseMaybe (sensorMessage ours) msg
  where
    lookup3 t ts = case filter (\(t', _, _) -> t' == t) ts of
      found : _ -> Just found
      [] -> Nothing
    -- Servers tell a topic as it was subscribed; some drop the slash.
    absolute t = if "/" `T.isPrefixOf` t then t else "/" <> t
