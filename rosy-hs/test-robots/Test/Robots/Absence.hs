{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : A program on a robot's link: its first tick, and what came while it was frozen. Time is in the test's hands.
module Test.Robots.Absence (tests) where

import Control.Concurrent.STM
import Data.Foldable (for_)
import Rosy.Channel (Message)
import Rosy.Link (Batch (..), Link (..), noAnswer)
import Rosy.Link.Real
import Rosy.Robot
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.UnreadableMessages (noneUnreadable)
import Rosy.Sentence (verbatim)
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "a program on a robot's link"
    [ testCase "that was frozen does not hear what was pressed meanwhile, and hears where it is" (afterFreeze 10 @?>= [position]),
      testCase "that was away for a moment only hears everything" (afterFreeze longestAbsence @?>= [press, position]),
      testCase "gets its first tick 100 ms after the robot is there, not after the link began to wait" (firstTick @?>= (1, False))
    ]
  where
    act @?>= expected = act >>= (@?= expected)

press, position :: Message
press = BumperMessage (Bumper CenterBumper Pressed)
position = OdometryMessage (Odometry (Position 0 0) (Orientation 0) (Velocity 0 0))

-- | What a program hears after so many seconds in which it did nothing, and its link queued a press and a position.
afterFreeze :: Double -> IO [Message]
afterFreeze seconds = do
  time <- newTVarIO 0
  queued <- newTVarIO [Connected]
  (link, due, _) <- linkWith time queued
  _ <- open link []
  atomically (writeTVar due True)
  step <- next link
  for_ step (const (answer link noAnswer))
  atomically (writeTVar time seconds >> writeTVar queued (map Received [press, position]))
  maybe [] batchMessages <$> next link

-- | How often the ticks of the clock have been started when the robot is there, and whether one is due then.
firstTick :: IO (Int, Bool)
firstTick = do
  (link, due, started) <- newTVarIO 0 >>= \time -> newTVarIO [Connected] >>= linkWith time
  before <- readTVarIO started
  _ <- open link []
  after <- readTVarIO started
  (,) (after - before) <$> readTVarIO due

-- | A link to a robot of which these events are queued: whether its tick is due, and how often its clock was started.
linkWith :: TVar Double -> TVar [RobotEvent] -> IO (Link, TVar Bool, TVar Int)
linkWith time queued = do
  due <- newTVarIO False
  started <- newTVarIO 0
  control <- newRunControl (newGuard (Limits 0.7 pi Nothing) False)
  let robot =
        Connection
          { connectionName = verbatim "here",
            connectionRoutes = [],
            registerTopics = const (pure []),
            sendCommand = const (pure ()),
            cancelGoals = pure (),
            refuseCall = \_ _ -> pure (),
            takeEvents = swapTVar queued [] >>= \events -> events <$ check (not (null events)),
            unreadableMessages = pure noneUnreadable,
            velocityTopic = pure Nothing
          }
  link <- realLink (Clock (readTVarIO time) (pure 0) due (atomically (modifyTVar' started (+ 1)))) 10 control robot
  pure (link, due, started)
