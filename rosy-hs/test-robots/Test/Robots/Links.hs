-- |
-- Description : Programs on robots behind rosbridge, on ROS 1 and on a serial line.
--
-- Each way has its robot: a strict rosbridge server, a rospy node, a base at the end of a pseudo-terminal. The same
-- stories are told of all three: however a program ends, the robot is told to stop, or its own watchdog sees the silence.
module Test.Robots.Links (tests) where

import Control.Monad (forM_, void)
import Data.List (isInfixOf)
import System.Environment (getExecutablePath)
import System.Exit (ExitCode (..))
import Test.Robots.Rigs
import Test.Ros.Peer
import Test.Tasty
import Test.Tasty.HUnit

tests :: Ready -> TestTree
tests ready =
  localOption (mkTimeout 60000000) . testGroup "links" $
    [ testGroup name [story ready rig title act | (title, act) <- stories]
      | (name, rig) <- [("rosbridge on ROS 1", rosbridge "1"), ("rosbridge on ROS 2", rosbridge "2"), ("ROS 1", rospy), ("serial", serial)]
    ]
      ++ [ testGroup "rosbridge alone" [story ready (rosbridge "1") "garbage is passed over, and a lost server is found again" lostServer],
           testGroup "serial alone" [story ready serial "noise, cut and corrupted packets are passed over, and a pulled cable is found again" pulledCable]
         ]

stories :: [(String, Rig -> IO ())]
stories =
  [ ( "it drives, backs off from a bumper by the safety rules, and stops when the system asks",
      \r ->
        driving r "on" "steady" $ \p -> do
          bumped r
          sees r "backing off" (backs r)
          signal p "TERM"
          sees r "a stop" (stands r)
          exits p 0
    ),
    ("a program lights an LED", \r -> driving r "off" "lights" $ \_ -> bumped r >> sees r "a red light" (red r)),
    ("it stops on Ctrl-C", \r -> driving r "off" "steady" $ \p -> signal p "INT" >> sees r "a stop" (stands r) >> exits p 0),
    ( "it stops, or is seen to be silent, when the program is killed",
      \r ->
        driving r "off" "steady" $ \p -> killPeer p >> sees r "a stop or silence" (standsOrSilent r)
    ),
    ( "it stops when a function fails",
      \r ->
        driving r "off" "fails" $ \p -> bumped r >> hearsWhere p "the reason" ("the bumper broke me" `isInfixOf`) >> sees r "a stop" (stands r) >> exits p 2
    ),
    ( "it stops, or is seen to be silent, when a function hangs, and Ctrl-C still ends the program",
      \r ->
        driving r "off" "hangs" $ \p -> bumped r >> sees r "a stop or silence" (standsOrSilent r) >> signal p "INT" >> exits p 2
    ),
    ("it stops when the program is done", \r -> driving r "off" "done" $ \p -> bumped r >> sees r "a stop" (stands r) >> exits p 0)
  ]
  where
    standsOrSilent r l = stands r l || l == "watchdog"

-- | A program of its own process, from when the robot moves.
driving :: Rig -> String -> String -> (Peer -> IO a) -> IO a
driving r safety name act = do
  streaming r
  self <- getExecutablePath
  withProgram (environment r) "/bin/sh" ["-c", "exec \"$@\" 2>&1", "sh", self, "--drive", url r ++ "?safety=" ++ safety ++ options r, name] $ \p -> do
    sees r "movement" (moves r)
    act p

sees :: Rig -> String -> (String -> Bool) -> IO ()
sees r what = void . hearsWhere (robot r) what

exits :: Peer -> Int -> IO ()
exits p code = exitOf p >>= (@?= if code == 0 then ExitSuccess else ExitFailure code)

lostServer :: Rig -> IO ()
lostServer r = driving r "off" "steady" $ \p -> do
  forM_ ["raw not json", "raw {\"op\":\"status\",\"level\":\"error\",\"msg\":\"x\"}", "raw {\"op\":\"publish\",\"topic\":\"/mobile_base/events/bumper\",\"msg\":{\"bumper\":9,\"state\":null}}", "raw [1]"] (say (robot r))
  say (robot r) "refuse"
  say (robot r) "drop"
  _ <- hearsWhere p "that it is lost" ("is lost" `isInfixOf`)
  say (robot r) "accept"
  _ <- hearsWhere p "that it is back" ("is back" `isInfixOf`)
  sees r "movement again" (moves r)

pulledCable :: Rig -> IO ()
pulledCable r = driving r "off" "steady" $ \p -> do
  forM_ ["noise", "cut", "corrupt", "noise"] (say (robot r))
  say (robot r) "unplug"
  _ <- hearsWhere p "that it is lost" ("is lost" `isInfixOf`)
  say (robot r) "bump 0"
  say (robot r) "plug"
  _ <- hearsWhere p "that it is back" ("is back" `isInfixOf`)
  signal p "TERM"
  sees r "a stop" (stands r)
  exits p 0
