{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : Addresses of robots.
module Test.Robots.Target (tests) where

import Rosy.Robots.Guard (Limits (..))
import Rosy.Robots.Target
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "addresses"
    [ testCase "the three ways, with and without ports" $ do
        fmap targetWay (readTarget "ws://pi:9091/bridge") @?= Right (Rosbridge "pi" 9091 "/bridge")
        fmap targetWay (readTarget "ws://pi") @?= Right (Rosbridge "pi" 9090 "/")
        fmap targetWay (readTarget "ros://10.0.0.7") @?= Right (Ros1 "10.0.0.7" 11311)
        fmap targetWay (readTarget "serial:/dev/kobuki?safety=off") @?= Right (Serial "/dev/kobuki"),
      testCase "without options a robot is a TurtleBot 2 at a Kobuki's limits, with the safety rules" $
        readTarget "ros://h" @?= Right (Target "ros://h" (Ros1 "h" 11311) turtlebot2 (Limits 0.7 pi) True 10),
      testCase "ros=2 changes names, and a prefix moves the topics that follow it" $ do
        fmap targetProfile (readTarget "ws://h?ros=2&prefix=/kitchen") @?= Right kobukiRos2 {prefix = "/kitchen", odometryTopic = "/kitchen/odom", velocityTopic = "/kitchen/commands/velocity"}
        fmap targetProfile (readTarget "ros://h?prefix=/b") @?= Right turtlebot2 {prefix = "/b", velocityTopic = "/b/commands/velocity"}
        fmap (velocityTopic . targetProfile) (readTarget "ros://h?velocity=/cmd_vel_mux/input/navi&prefix=/b") @?= Right "/cmd_vel_mux/input/navi"
        fmap (velocityTopic . targetProfile) (readTarget "ws://h?ros=2&velocity=/cmd_vel&prefix=/kitchen") @?= Right "/cmd_vel"
        fmap (odometryTopic . targetProfile) (withFile (Just "{\"ros\": 2, \"odometry\": \"/o\", \"prefix\": \"/a\"}") "ws://h?prefix=/b&profile=x") @?= Right "/o",
      testCase "a profile's options come first, those of the address win" $
        fmap (\t -> (targetLimits t, targetProfile t)) (withFile (Just "{\"max_speed\": 0.3, \"max_turn\": 1, \"ros\": \"2\"}") "ws://h?profile=x.json&max_speed=.2")
          @?= Right (Limits 0.2 1, kobukiRos2),
      testCase "a profile's numbers may be numbers" $
        fmap (\t -> (targetProfile t, targetPatience t)) (withFile (Just "{\"ros\": 2, \"patience\": 5}") "ws://h?profile=x.json") @?= Right (kobukiRos2, 5),
      testCase "what cannot be read is said" $ do
        readTarget "http://h" @?= Left (StrangeTarget "http://h")
        readTarget "ws://h:99999" @?= Left (StrangeTarget "ws://h:99999")
        readTarget "ws://h?colour=red" @?= Left (StrangeOption "colour")
        readTarget "ws://h?max_speed=-1" @?= Left (StrangeValue "max_speed" "-1")
        readTarget "ws://h?safety=maybe" @?= Left (StrangeValue "safety" "maybe")
        withFile (Just "[]") "ws://h?profile=x" @?= Left (StrangeProfile "x")
    ]
