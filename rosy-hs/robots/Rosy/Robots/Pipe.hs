{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.Pipe
-- Description : The simulator's side of the pipe, as lines.
--
-- In: what a robot senses; lines from a program. Out: lines for the program; what it wants. Pure; the lines are
-- those of @protocol/README.md@ section 2, read and written from the other end than "Rosy.Wire" does.
module Rosy.Robots.Pipe
  ( startLine,
    batchLines,
    stopLine,
    Wish (..),
    readWish,
  )
where

import Data.Aeson (Object, Value (..), (.!=), (.:), (.:?))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (Parser, parseMaybe)
import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder, doubleDec, intDec)
import Data.Text (Text)
import Rosy.Core (Action (..), Message (..), Odometry (..))
import Rosy.Robot

startLine :: Int -> Builder
startLine seed = "{\"op\":\"start\",\"protocol\":1,\"seed\":" <> intDec seed <> ",\"trace\":false}\n"

stopLine :: Builder
stopLine = "{\"op\":\"stop\"}\n"

-- | The messages of a step, and its number and time.
batchLines :: Int -> Double -> [Message] -> Builder
batchLines step time messages =
  foldMap sensorLine messages <> "{\"op\":\"step\",\"step\":" <> intDec step <> ",\"time\":" <> doubleDec time <> "}\n"

sensorLine :: Message -> Builder
sensorLine m = case m of
  ButtonMessage (Button n s) -> event "button" "button" n (fromEnum (s == Pressed))
  BumperMessage (Bumper n s) -> event "bumper" "bumper" n (fromEnum (s == Pressed))
  CliffMessage (Cliff n s) -> event "cliff" "sensor" n (fromEnum (s == Hole))
  WheelMessage (Wheel n s) -> event "wheel_drop" "wheel" n (fromEnum (s == Air))
  StatusMessage s -> publish "/mobile_base/events/robot_state" ("{\"state\":" <> intDec (fromEnum (s == Online)) <> "}")
  OdometryMessage (Odometry (Position x y) (Orientation a) (Velocity v w)) ->
    publish "/odom" $
      ("{\"pose\":{\"pose\":{\"position\":{\"x\":" <> doubleDec x <> ",\"y\":" <> doubleDec y)
        <> ("},\"orientation\":{\"z\":" <> doubleDec (sin (a / 2)) <> ",\"w\":" <> doubleDec (cos (a / 2)))
        <> ("}}},\"twist\":{\"twist\":{\"linear\":{\"x\":" <> doubleDec v <> "},\"angular\":{\"z\":" <> doubleDec w <> "}}}}")
  where
    event :: Enum n => Builder -> Builder -> n -> Int -> Builder
    event topic which n s = publish ("/mobile_base/events/" <> topic) ("{\"" <> which <> "\":" <> intDec (fromEnum n) <> ",\"state\":" <> intDec s <> "}")
    publish topic msg = "{\"op\":\"publish\",\"topic\":\"" <> topic <> "\",\"msg\":" <> msg <> "}\n"

-- | What a program says.
data Wish
  = Wants Action
  | Ready
  | -- | It has done all that this step makes it do; these functions fired.
    Settled [Text]
  | -- | It has ended: @done@, @stopped@ or @error@, with what a person should know, what to do, and all of the problem.
    HasEnded Text (Maybe (Text, Text, Value))
  | -- | It names its topics.
    NamesTopics
  deriving (Eq, Show)

-- | Nothing for a line that protocol/README.md does not have.
readWish :: ByteString -> Maybe Wish
readWish bytes = case Aeson.decodeStrict' bytes of
  Just (Object o) -> parseMaybe wish o
  _ -> Nothing

wish :: Object -> Parser Wish
wish o = do
  op <- o .: "op"
  case op :: Text of
    "publish" -> Wants <$> (o .: "topic" >>= \t -> o .: "msg" >>= action t)
    "settled" -> Settled <$> o .:? "fired" .!= []
    "ready" -> pure Ready
    "advertise" -> pure NamesTopics
    "subscribe" -> pure NamesTopics
    "ended" -> do
      problem <- o .:? "problem"
      HasEnded <$> o .: "how" <*> traverse (\p -> (,,) <$> p .: "message" <*> p .:? "hint" .!= "" <*> pure (Object p)) problem
    _ -> fail "unknown op"

action :: Text -> Object -> Parser Action
action topic msg = case topic of
  "/mobile_base/commands/velocity" -> SetVelocity <$> (msg .: "linear" >>= (.: "x")) <*> (msg .: "angular" >>= (.: "z"))
  "/mobile_base/commands/led1" -> SetLed1 <$> value
  "/mobile_base/commands/led2" -> SetLed2 <$> value
  "/mobile_base/commands/sound" -> PlaySound <$> value
  "/rosy/say" -> SayText <$> msg .: "data"
  _ -> fail "unknown topic"
  where
    value :: (Enum a, Bounded a) => Parser a
    value = do
      n <- msg .: "value"
      case drop n [minBound ..] of
        x : _ | n >= 0 -> pure x
        _ -> fail "out of range"
