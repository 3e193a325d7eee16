{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : A program on a robot's link: its ticks, and after it was frozen what came meanwhile and what was on its way to the robot. Time is in
--               the test's hands.
module Test.Robots.Absence (tests) where

import Control.Concurrent.STM
import Data.Foldable (for_)
import Rosy.Channel (Action, Message)
import Rosy.Link (Batch (..), Link (..), noAnswer)
import Rosy.Link.Real
import Rosy.Robot
import Rosy.Robots.Connection
import Rosy.Robots.Expiry
import Rosy.Robots.Guard
import Rosy.Robots.UnreadableMessages (noneUnreadable)
import Rosy.Sentence (verbatim)
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "time of a program on a robot"
    [ testCase "its ticks begin when the robot is there, the first one at once" $ do
        ticking <- newTVarIO False
        (link, _, _) <- linked (atomically (readTVar ticking >>= \twice -> writeTVar ticking (not twice)))
        before <- readTVarIO ticking
        _ <- open link []
        after <- readTVarIO ticking
        (before, after) @?= (False, True)
        withClock $ \clock -> do
          startTicks clock
          -- Waits for ever where none comes.
          atomically (readTVar (tickDue clock) >>= check),
      frozen
    ]

frozen :: TestTree
frozen =
  testGroup
    "a program that was frozen"
    [ testCase "does not hear what was pressed meanwhile, and hears where it is" (afterFreeze 10 @?>= [position]),
      testCase "hears everything where it was away for a moment only" (afterFreeze longestAbsence @?>= [press, position]),
      testCase "may send a movement that is as old as an absence may be, and a stop in place of an older one" $
        [valueAt (10 + age) (10 + age) (expiring 10 movement) | age <- [0, longestAbsence, longestAbsence + 0.001, 1e6]] @?= [movement, movement, stop, stop],
      testCase "sends a stop in place of a new movement when its guardian may have stopped the robot" $
        [valueAt heartbeat 10 (expiring 10 movement) | heartbeat <- [10, 10 - longestAbsence, 10 - longestAbsence - 0.001, 0]] @?= [movement, movement, stop, stop],
      testCase "sends a stop and what moves nothing, however old they are" $
        [valueAt 10 1e6 (expiring 10 a) | a <- [stop, light]] @?= [stop, light]
    ]
  where
    act @?>= expected = act >>= (@?= expected)

movement, stop, light :: Action
movement = VelocityCommand (Velocity 0 0.5)
stop = VelocityCommand (Velocity 0 0)
light = Led1Command (Led1 Red)

press, position :: Message
press = BumperMessage (Bumper CenterBumper Pressed)
position = OdometryMessage (Odometry (Position 0 0) (Orientation 0) (Velocity 0 0))

-- | What a program hears after so many seconds in which it did nothing, and its link queued a press and a position.
afterFreeze :: Double -> IO [Message]
afterFreeze seconds = do
  (link, time, queued) <- linked (pure ())
  _ <- open link []
  step <- next link
  for_ step (const (answer link noAnswer))
  atomically (writeTVar time seconds >> writeTVar queued (map Received [press, position]))
  maybe [] batchMessages <$> next link

-- | A link to a robot that is there; its clock, and what the robot sends. A tick is due. The action is what starts the ticks.
linked :: IO () -> IO (Link, TVar Double, TVar [RobotEvent])
linked starts = do
  time <- newTVarIO 0
  due <- newTVarIO True
  queued <- newTVarIO [Connected]
  control <- newRunControl (newGuard (Limits 0.7 pi Nothing) False)
  let robot =
        Connection
          { connectionName = verbatim "here",
            connectionRoutes = [],
            registerTopics = const (pure []),
            sendCommand = \_ _ -> pure (),
            cancelGoals = pure (),
            refuseCall = \_ _ -> pure (),
            takeEvents = swapTVar queued [] >>= \events -> events <$ check (not (null events)),
            unreadableMessages = pure noneUnreadable,
            velocityTopic = pure Nothing
          }
  link <- realLink (Clock (readTVarIO time) (pure 0) starts due) 10 control robot
  pure (link, time, queued)
