{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.Telemetry
-- Description : What a person who watches a robot is told of it, as lines.
--
-- In: what the robot senses and what it is told. Out: a picture of it, and the lines of @protocol/README.md@
-- section 7. Pure.
module Rosy.Robots.Telemetry
  ( -- * The picture
    Picture,
    blank,
    sensed,
    told,
    firedBy,
    frameLine,
    restarted,

    -- * The other lines
    holdingLine,
    linkLine,
    saidLine,
    soundLine,
    endedLine,
    stoppedLine,
  )
where

import Data.Aeson (Value, object, (.=))
import qualified Data.Aeson as Aeson
import Data.Bits (clearBit, setBit)
import qualified Data.ByteString.Lazy as L
import Data.Text (Text)
import Rosy.Core (Action (..), Message (..), Odometry (..))
import Rosy.Robot
import Rosy.Robots.Base (Notice (..))

-- | The robot as it is known to be. Bits as in kobuki_msgs/SensorState: right 1, centre 2, left 4; wheels right 1, left 2;
-- button n is bit n.
data Picture = Picture
  { at :: !Odometry,
    bumpers, cliffs, wheels, buttons :: !Int,
    led1, led2 :: !LedColor,
    -- | since the last frame, newest first
    fired :: ![Text]
  }

blank :: Picture
blank = Picture (Odometry (Position 0 0) (Orientation 0) (Velocity 0 0)) 0 0 0 0 Black Black []

-- | Another run: it starts where the robot is, and what is pressed or lit stays so.
restarted :: Picture -> Picture
restarted p = p {at = at blank, fired = []}

sensed :: Message -> Picture -> Picture
sensed m p = case m of
  OdometryMessage o -> p {at = o}
  -- Sides are counted from the left, bits from the right.
  BumperMessage (Bumper n s) -> p {bumpers = bit' (s == Pressed) (2 - fromEnum n) (bumpers p)}
  CliffMessage (Cliff n s) -> p {cliffs = bit' (s == Hole) (2 - fromEnum n) (cliffs p)}
  WheelMessage (Wheel n s) -> p {wheels = bit' (s == Air) (1 - fromEnum n) (wheels p)}
  ButtonMessage (Button n s) -> p {buttons = bit' (s == Pressed) (fromEnum n) (buttons p)}
  StatusMessage _ -> p
  where
    bit' yes n x = if yes then setBit x n else clearBit x n

told :: Action -> Picture -> Picture
told a p = case a of
  SetLed1 c -> p {led1 = c}
  SetLed2 c -> p {led2 = c}
  _ -> p

-- | Names of functions; a picture remembers the latest two hundred.
firedBy :: [Text] -> Picture -> Picture
firedBy names p = p {fired = take 200 (reverse names ++ fired p)}

-- | The line of a picture so many seconds after the run began, and the picture after it was shown. @backing@: the safety
-- rules own the wheels.
frameLine :: Double -> Bool -> Picture -> (L.ByteString, Picture)
frameLine time backing p =
  ( line
      [ "op" .= ("frame" :: Text),
        "time" .= time,
        "x" .= x,
        "y" .= y,
        "theta" .= theta,
        "v" .= v,
        "w" .= w,
        "bumpers" .= bumpers p,
        "cliffs" .= cliffs p,
        "wheels" .= wheels p,
        "buttons" .= buttons p,
        "led1" .= fromEnum (led1 p),
        "led2" .= fromEnum (led2 p),
        "fired" .= reverse (fired p),
        "backing" .= backing
      ],
    p {fired = []}
  )
  where
    Odometry (Position x y) (Orientation theta) (Velocity v w) = at p

-- | Whether the safety rules are on, and the fastest that a program may go: m/s and rad/s.
holdingLine :: Bool -> Double -> Double -> L.ByteString
holdingLine safety v w = line ["op" .= ("holding" :: Text), "safety" .= safety, "max_speed" .= v, "max_turn" .= w]

linkLine :: Notice -> L.ByteString
linkLine n = case n of
  IsAwaited why -> link "connecting" why
  IsThere -> link "connected" ""
  IsLost why -> link "lost" why
  IsBack -> link "connected" ""
  where
    link :: Text -> String -> L.ByteString
    link state why = line ["op" .= ("link" :: Text), "link" .= state, "why" .= why]

saidLine :: Double -> String -> L.ByteString
saidLine time text = line ["op" .= ("said" :: Text), "time" .= time, "text" .= take 10000 text]

soundLine :: Double -> Sound -> L.ByteString
soundLine time s = line ["op" .= ("sound" :: Text), "time" .= time, "sound" .= fromEnum s]

-- | How a run ended, and the problem as the program told it.
endedLine :: Double -> Text -> Maybe Value -> L.ByteString
endedLine time how problem = line (["op" .= ("ended" :: Text), "time" .= time, "how" .= how] ++ ["problem" .= p | Just p <- [problem]])

-- | Whether the emergency stop holds the wheels.
stoppedLine :: Bool -> L.ByteString
stoppedLine yes = line ["op" .= ("stopped" :: Text), "stopped" .= yes]

line :: [(Aeson.Key, Value)] -> L.ByteString
line fields = Aeson.encode (object fields) <> "\n"
