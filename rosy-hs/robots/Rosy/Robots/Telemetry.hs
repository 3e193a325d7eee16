{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Robots.Telemetry
-- Description : State of a robot for display, as lines.
--
-- In: messages and commands. Out: the state of the robot, and the lines of @protocol/README.md@
-- section 7. Pure.
module Rosy.Robots.Telemetry
  ( -- * State
    RobotState,
    initialState,
    applyMessage,
    applyCommand,
    recordFirings,
    frameLine,
    restart,

    -- * The other lines
    holdingLine,
    linkLine,
    saidLine,
    soundLine,
    commandsLine,
    endedLine,
    stoppedLine,
  )
where

import Data.Aeson (Value (Null), object, (.=))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.ByteString.Lazy as L
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import Rosy.Channel
import Rosy.Profile
import Rosy.Request (pattern RequestAction)
import Rosy.Robot
import Rosy.Robots.Connection (Notice (..), stillness, unknownReason)
import Rosy.Sentence (Sentence, english, sentenceId)
import Rosy.Topic (pattern OpenAction)

-- | The known state of a robot.
data RobotState = RobotState
  { at :: !Odometry,
    -- | By the number of its channel: its name, and its values or the state of each of its places.
    channels :: !(Map.Map Int (String, [Field])),
    -- | since the last frame, newest first
    fired :: ![Text],
    -- | events since the last frame as Haskell shows them, newest first
    events :: ![String]
  }

-- | The state before the first message.
initialState :: Robot -> RobotState
initialState robot = RobotState originOdometry (Map.fromList (places ++ held)) [] []
  where
    places = [(channelNumber c, (channelName c, replicate (channelPlaces c) (Whole 0))) | m <- robotMappings robot, let c = mappingChannel m, channelKind c == EventChannel, channelPlaces c > 0]
    held = [(channelNumber c, (channelName c, values)) | (c, values) <- robotHeld robot]

originOdometry :: Odometry
originOdometry = Odometry (Position 0 0) (Orientation 0) (Velocity 0 0)

-- | Another run: it starts where the robot is, and what is pressed or lit stays so.
restart :: RobotState -> RobotState
restart p = p {at = originOdometry, fired = [], events = []}

applyMessage :: Message -> RobotState -> RobotState
applyMessage m@(Message c fields) p = case m of
  OdometryMessage o -> p {at = o}
  _ | channelKind c == EventChannel -> (set c fields p) {events = take 50 (tellMessage m : events p)}
  _ -> set c fields p

-- | Keeps the lasting effect of a command.
applyCommand :: Action -> RobotState -> RobotState
applyCommand (Action c fields) p
  | Map.member (channelNumber c) (channels p) = set c fields p
  | otherwise = p

-- | The values of a channel; a place of one that has several.
set :: Channel -> [Field] -> RobotState -> RobotState
set c fields p = p {channels = Map.alter (Just . (,) (channelName c) . change . maybe [] snd) (channelNumber c) (channels p)}
  where
    change old = case fields of
      [Whole i, state] | channelPlaces c > 0 -> [if j == i then state else x | (j, x) <- zip [0 ..] (old ++ replicate (channelPlaces c - length old) (Whole 0))]
      _ -> fields

-- | Names of functions; the latest two hundred are kept.
recordFirings :: [Text] -> RobotState -> RobotState
recordFirings names p = p {fired = take 200 (reverse names ++ fired p)}

-- | The frame at a time in seconds since the run began, and the state with empty lists of firings and events. @backing@: the safety
-- rules own the wheels.
frameLine :: Double -> Bool -> RobotState -> (L.ByteString, RobotState)
frameLine time backing p =
  ( line
      [ "op" .= ("frame" :: Text),
        "time" .= time,
        "pose" .= object ["x" .= x, "y" .= y, "theta" .= theta],
        "channels" .= object (("Velocity" .= [v, w]) : [Key.fromString name .= map fieldValue fields | (name, fields) <- Map.elems (channels p)]),
        "fired" .= reverse (fired p),
        "sensed" .= reverse (events p),
        "backing" .= backing
      ],
    p {fired = [], events = []}
  )
  where
    Odometry (Position x y) (Orientation theta) (Velocity v w) = at p

fieldValue :: Field -> Value
fieldValue field = case field of
  Number n -> Aeson.toJSON n
  Whole n -> Aeson.toJSON n
  Text s -> Aeson.toJSON s
  Structure tree -> tree

-- | Whether the safety rules are on, and the fastest that a program may go: m/s and rad/s.
holdingLine :: Bool -> Double -> Double -> L.ByteString
holdingLine safety v w = line ["op" .= ("holding" :: Text), "safety" .= safety, "max_speed" .= v, "max_turn" .= w]

linkLine :: Notice -> L.ByteString
linkLine n = case n of
  IsAwaited why -> link "connecting" why
  IsThere -> link "connected" unknownReason
  IsLost why -> link "lost" why
  IsBack -> link "connected" unknownReason
  IsRefused why -> link "lost" why
  -- Says nothing about the link but that it is there.
  IsComplaining _ -> link "connected" unknownReason
  IsUnreadable _ -> link "connected" unknownReason
  IsStill topic -> link "connected" (stillness topic)
  IsMoving -> link "connected" unknownReason
  where
    link :: Text -> Sentence -> L.ByteString
    link state why = line (["op" .= ("link" :: Text), "link" .= state, "why" .= english why] ++ ["sentence" .= s | Just s <- [sentenceId why]])

saidLine :: Double -> String -> L.ByteString
saidLine time text = line ["op" .= ("said" :: Text), "time" .= time, "text" .= take 10000 text]

soundLine :: Double -> Sound -> L.ByteString
soundLine time s = line ["op" .= ("sound" :: Text), "time" .= time, "sound" .= fromEnum s]

-- | The commands of a step in which these functions fired, and how many each of them sent. A message on a topic of the program's own
-- has no channel. Of an observed step also whether the safety rules own the wheels, and what the program told of it.
commandsLine :: Double -> [Text] -> [Int] -> [Action] -> Maybe (Bool, Value) -> L.ByteString
commandsLine time names sent commands observed =
  line $
    ["op" .= ("commands" :: Text), "time" .= time, "fired" .= names, "sent" .= sent, "commands" .= map command commands]
      ++ concat [["backing" .= backing, "observed" .= told] | Just (backing, told) <- [observed]]
  where
    command (RequestAction _) = object ["channel" .= Null, "values" .= ([] :: [Value])]
    command (OpenAction _ _) = object ["channel" .= Null, "values" .= ([] :: [Value])]
    command (Action c fields) = object ["channel" .= channelName c, "values" .= map fieldValue fields]

-- | How a run ended, and the problem as the program told it.
endedLine :: Double -> Text -> Maybe Value -> L.ByteString
endedLine time how problem = line (["op" .= ("ended" :: Text), "time" .= time, "how" .= how] ++ ["problem" .= p | Just p <- [problem]])

-- | Whether the emergency stop holds the wheels.
stoppedLine :: Bool -> L.ByteString
stoppedLine yes = line ["op" .= ("stopped" :: Text), "stopped" .= yes]

line :: [(Aeson.Key, Value)] -> L.ByteString
line fields = Aeson.encode (object fields) <> "\n"
