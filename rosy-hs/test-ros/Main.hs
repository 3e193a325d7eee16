-- |
-- Description : Everything about the ROS client, without ROS and with it.
module Main (main) where

import System.Environment (getArgs)
import qualified Test.Ros.Generator
import qualified Test.Ros.Genpy
import qualified Test.Ros.Listings
import qualified Test.Ros.Messages
import qualified Test.Ros.Names
import qualified Test.Ros.Net
import qualified Test.Ros.Roshask
import qualified Test.Ros.Stamped
import qualified Test.Ros.System
import qualified Test.Ros.Topic
import Test.Tasty

main :: IO ()
main =
  getArgs >>= \case
    -- The tests start this program again as nodes of their own.
    "--node" : _ -> Test.Ros.System.aNode
    "--echo" : _ -> Test.Ros.System.anEcho
    _ -> defaultMain suite

suite :: TestTree
suite =
  testGroup
    "ros"
    [ Test.Ros.Generator.tests,
      Test.Ros.Listings.tests,
      Test.Ros.Messages.tests,
      Test.Ros.Names.tests,
      Test.Ros.Net.tests,
      Test.Ros.Stamped.tests,
      Test.Ros.Roshask.tests,
      Test.Ros.System.tests,
      Test.Ros.Topic.tests,
      Test.Ros.Genpy.tests
    ]
