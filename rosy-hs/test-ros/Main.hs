-- |
-- Description : Everything about the ROS client that needs no ROS.
module Main (main) where

import qualified Test.Ros.Generator
import qualified Test.Ros.Messages
import qualified Test.Ros.Names
import qualified Test.Ros.Net
import qualified Test.Ros.System
import qualified Test.Ros.Topic
import Test.Tasty

main :: IO ()
main =
  defaultMain . testGroup "ros" $
    [ Test.Ros.Generator.tests,
      Test.Ros.Messages.tests,
      Test.Ros.Names.tests,
      Test.Ros.Net.tests,
      Test.Ros.System.tests,
      Test.Ros.Topic.tests
    ]
