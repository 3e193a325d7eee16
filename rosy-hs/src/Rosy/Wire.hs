{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Wire
-- Description : The robot link in JSON: lines to messages, commands to lines.
--
-- Pure. The lines are those of @protocol/README.md@ section 2, and the golden conversations in @protocol/goldens/link@
-- hold both directions. Integers leave without a decimal point, because real rosbridge servers refuse @1.0@ for one.
module Rosy.Wire
  ( -- * What arrives
    Line (..),
    readLine,
    sensorMessage,

    -- * What leaves
    writeOpening,
    writeAnswer,
    writeEnding,

    -- * In words
    tellAction,
  )
where

import Data.Aeson (Object, Value (..), (.!=), (.:), (.:?))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Encoding as Encoding
import Data.Aeson.Types (Parser, parseEither)
import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import Data.Text (Text)
import Rosy.Core
import Rosy.Link
import Rosy.Problem
import Rosy.Robot
import Rosy.Value (shown)

-- ---------------------------------------------------------------------------------------------
-- What arrives

-- | A line from the simulator.
data Line
  = -- | Protocol version, seed, trace.
    StartLine Int Int Bool
  | SensorLine Message
  | -- | Number and time (s) of the step whose messages came before, and whether the memory is looked at.
    StepLine Int Double Bool
  | StopLine
  deriving (Eq, Show)

-- | What a line says, or why it says nothing.
readLine :: ByteString -> Either String Line
readLine bytes = case Aeson.decodeStrict' bytes of
  Just (Object o) -> parseEither line o
  _ -> Left "not a JSON object"

line :: Object -> Parser Line
line o = do
  op <- o .: "op"
  case op :: Text of
    "publish" -> do
      topic <- o .: "topic"
      msg <- o .: "msg"
      SensorLine <$> sensorMessage topic msg
    "step" -> StepLine <$> o .: "step" <*> o .: "time" <*> o .:? "memory" .!= False
    "start" -> StartLine <$> o .: "protocol" <*> o .: "seed" <*> o .:? "trace" .!= False
    "stop" -> pure StopLine
    _ -> fail ("unknown op " ++ show op)

-- | kobuki_msgs and nav_msgs, as the table of topics in protocol/README.md has them.
sensorMessage :: Text -> Object -> Parser Message
sensorMessage topic msg = case topic of
  "/odom" -> OdometryMessage <$> odometry msg
  "/mobile_base/events/bumper" -> fmap BumperMessage (Bumper <$> field "bumper" [LeftBumper ..] <*> field "state" [Released, Pressed])
  "/mobile_base/events/cliff" -> fmap CliffMessage (Cliff <$> field "sensor" [LeftCliff ..] <*> field "state" [Floor, Hole])
  "/mobile_base/events/wheel_drop" -> fmap WheelMessage (Wheel <$> field "wheel" [LeftWheel ..] <*> field "state" [Ground, Air])
  "/mobile_base/events/button" -> fmap ButtonMessage (Button <$> field "button" [Button0 ..] <*> field "state" [Released, Pressed])
  "/mobile_base/events/robot_state" -> StatusMessage <$> field "state" [Offline, Online]
  _ -> fail ("unknown topic " ++ show topic)
  where
    field key values = do
      i <- msg .: key
      case drop i values of
        value : _ | i >= 0 -> pure value
        _ -> fail (show key ++ " is out of range")

-- | The heading comes from the quaternion about the vertical axis: yaw = 2 atan2 z w.
odometry :: Object -> Parser Odometry
odometry msg = do
  pose <- msg .: "pose" >>= (.: "pose")
  position <- pose .: "position"
  x <- position .: "x"
  y <- position .: "y"
  quaternion <- pose .: "orientation"
  qz <- quaternion .: "z"
  qw <- quaternion .: "w"
  twist <- msg .: "twist" >>= (.: "twist")
  v <- twist .: "linear" >>= (.: "x")
  w <- twist .: "angular" >>= (.: "z")
  let heading = 2 * atan2 qz qw
      wrapped
        | heading > pi = heading - 2 * pi
        | heading <= negate pi = heading + 2 * pi
        | otherwise = heading
  pure (Odometry (Position x y) (Orientation wrapped) (Velocity v w))

-- ---------------------------------------------------------------------------------------------
-- What leaves

-- | The lines before the first step: what the program sends, what it takes, and that it is ready.
writeOpening :: Builder
writeOpening =
  foldMap (topicLine "advertise") commandTopics
    <> foldMap (topicLine "subscribe") sensorTopics
    <> "{\"op\":\"ready\"}\n"
  where
    topicLine op (topic, kind) =
      "{\"op\":\"" <> op <> "\",\"topic\":\"" <> topic <> "\",\"type\":\"" <> kind <> "\"}\n"
    commandTopics =
      [ (velocityTopic, "geometry_msgs/Twist"),
        ("/mobile_base/commands/led1", "kobuki_msgs/Led"),
        ("/mobile_base/commands/led2", "kobuki_msgs/Led"),
        ("/mobile_base/commands/sound", "kobuki_msgs/Sound"),
        ("/rosy/say", "std_msgs/String")
      ]
    sensorTopics =
      [ ("/mobile_base/events/button", "kobuki_msgs/ButtonEvent"),
        ("/mobile_base/events/bumper", "kobuki_msgs/BumperEvent"),
        ("/mobile_base/events/cliff", "kobuki_msgs/CliffEvent"),
        ("/mobile_base/events/wheel_drop", "kobuki_msgs/WheelDropEvent"),
        ("/mobile_base/events/robot_state", "kobuki_msgs/RobotStateEvent"),
        ("/odom", "nav_msgs/Odometry")
      ]

velocityTopic :: Builder
velocityTopic = "/mobile_base/commands/velocity"

-- | A batch: commands in firing order, then that the program has settled. With trace also in words.
writeAnswer :: Bool -> Answer -> Builder
writeAnswer trace a =
  foldMap action (answerActions a)
    <> "{\"op\":\"settled\",\"step\":"
    <> Builder.intDec (answerStep a)
    <> done trace a
    <> "}\n"

-- | The last batch: commands, zero velocity, and how the program ended. With trace also in words.
writeEnding :: Bool -> Answer -> Ending -> Builder
writeEnding trace a ending =
  foldMap action (answerActions a')
    <> "{\"op\":\"ended\",\"how\":"
    <> ( case ending of
           EndedDone -> "\"done\""
           EndedStopped -> "\"stopped\""
           EndedError p -> "\"error\",\"problem\":" <> problem p
       )
    <> done trace a'
    <> "}\n"
  where
    a' = a {answerActions = answerActions a ++ [SetVelocity 0 0]}

-- | What fired in a step, with trace what was heard and said, and what is remembered when somebody looks.
done :: Bool -> Answer -> Builder
done trace a =
  ",\"fired\":"
    <> list (text . nameText) (answerFired a)
    <> ( if trace
           then ",\"events\":" <> list text (answerEvents a) <> ",\"commands\":" <> list (text . tellAction) (answerActions a)
           else mempty
       )
    <> foldMap (\kept -> ",\"memory\":" <> list remember kept) (answerMemory a)
  where
    remember (what, value) = "{\"type\":" <> text what <> ",\"value\":" <> text value <> "}"

action :: Action -> Builder
action a = case a of
  SetVelocity v w ->
    publish velocityTopic ("{\"linear\":{\"x\":" <> Builder.doubleDec v <> "},\"angular\":{\"z\":" <> Builder.doubleDec w <> "}}")
  SetLed1 c -> publish "/mobile_base/commands/led1" (value (fromEnum c))
  SetLed2 c -> publish "/mobile_base/commands/led2" (value (fromEnum c))
  PlaySound s -> publish "/mobile_base/commands/sound" (value (fromEnum s))
  SayText s -> publish "/rosy/say" ("{\"data\":" <> text s <> "}")
  where
    publish topic msg = "{\"op\":\"publish\",\"topic\":\"" <> topic <> "\",\"msg\":" <> msg <> "}\n"
    value n = "{\"value\":" <> Builder.intDec n <> "}"

problem :: Problem -> Builder
problem p =
  "{\"severity\":\"error\",\"kind\":" <> text (problemKind p)
    <> foldMap (\f -> ",\"function\":" <> text f) (problemFunction p)
    <> ",\"message\":"
    <> text (problemMessage p)
    <> ",\"hint\":"
    <> text (problemHint p)
    <> ",\"ghc\":"
    <> text (problemOriginal p)
    <> foldMap (\t -> ",\"time\":" <> Builder.doubleDec t) (problemTime p)
    <> ",\"inputs\":"
    <> list text (problemInputs p)
    <> "}"

-- | A text in JSON. Half a pair of surrogates, which Haskell lets stand in a text, cannot be written in UTF-8.
text :: String -> Builder
text = Encoding.fromEncoding . Encoding.string . map whole
  where
    whole c = if c >= '\xD800' && c <= '\xDFFF' then '\xFFFD' else c

list :: (a -> Builder) -> [a] -> Builder
list _ [] = "[]"
list f (x : xs) = "[" <> f x <> foldMap (\y -> "," <> f y) xs <> "]"

-- | A command as Haskell shows it: @Velocity 0.5 0.0@.
tellAction :: Action -> String
tellAction a = case a of
  SetVelocity v w -> shown (Velocity v w)
  SetLed1 c -> shown (Led1 c)
  SetLed2 c -> shown (Led2 c)
  PlaySound s -> shown s
  SayText s -> shown (Say s)
