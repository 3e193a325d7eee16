{-# LANGUAGE DataKinds #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Robots.Distance
-- Description : Laser scans of robots on their way to a program: from a rosbridge server and from ROS 1, over the robot link.
module Test.Robots.Distance (tests) where

import Data.Aeson (Value, object, (.=))
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Ros.Message (DecodeError, decode, encode)
import Rosy.Channel (Message, tellMessage)
import Rosy.Codec (readMessages, routes)
import Rosy.Profile (Robot (..))
import Rosy.Robot.Known (robots)
import Rosy.Robots.DynamicMessage (DynamicMessage (..))
import Rosy.Robots.PipeCodec (batchLines, noQuestions)
import Rosy.Robots.RosbridgeCodec (decodeFrame)
import qualified Rosy.Wire as Wire
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "distances"
    [ testCase "of a TurtleBot 3 behind a rosbridge server reach the program" $
        -- 0, as its driver writes, and null, as servers write infinity, are beams that meet nothing.
        heard (decodeFrame turtlebot [] "{\"op\":\"publish\",\"topic\":\"/scan\",\"msg\":{\"header\":{},\"angle_min\":0,\"angle_max\":3,\"angle_increment\":1,\"time_increment\":0,\"scan_time\":0.2,\"range_min\":0.125,\"range_max\":3.5,\"ranges\":[0.75,0.0,null,0.5],\"intensities\":[]}}")
          @?= ["Ahead 0.75", "Scan 0.0 1.0 0.125 3.5 [0.75,3.5,3.5,0.5]"],
      testCase "of a scanner on a Kobuki, in the bytes of ROS 1, reach the program" $ do
        let bytes = encode (DynamicMessage scan :: DynamicMessage "sensor_msgs/LaserScan")
        case decode bytes :: Either DecodeError (DynamicMessage "sensor_msgs/LaserScan") of
          Left e -> assertFailure (show e)
          Right (DynamicMessage message) -> fmap heard (readMessages kobuki "/scan" message) @?= Right ["Ahead 0.75", "Scan 0.0 1.0 0.125 3.5 [0.75,3.5,0.5]"]
    ]
  where
    turtlebot = known "turtlebot3"
    kobuki = known "kobuki"
    known name = concat [routes r variables | r <- robots, robotName r == name, (_, variables) <- take 1 (robotProfiles r)]

scan :: Value
scan = object ["angle_increment" .= (1 :: Double), "range_min" .= (0.125 :: Double), "range_max" .= (3.5 :: Double), "ranges" .= ([0.75, 0, 0.5] :: [Double])]

-- | What a program hears when these messages are sent to it in a step.
heard :: [Message] -> [String]
heard messages = concat [map tellMessage found | line <- C.lines bytes, Right (Wire.SensorLine found) <- [Wire.readLine line]]
  where
    bytes = L.toStrict (Builder.toLazyByteString (batchLines noQuestions 0 0 messages))
