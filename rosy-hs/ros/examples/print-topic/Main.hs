-- |
-- Description : Prints what the base's bumpers say.
--
-- > ros-print-topic [bumper:=/mobile_base/events/bumper]
module Main (main) where

import Ros.Kobuki_msgs.BumperEvent (BumperEvent)
import Ros.Node

main :: IO ()
main = runNode "print_topic" $ do
  bumps <- subscribe "bumper"
  runHandler_ (print :: BumperEvent -> IO ()) bumps
