{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : The link to a real robot: when its ticks begin, and what a program that was frozen receives and sends. Time is set by the test.
module Test.Robots.RealLink (tests) where

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
    "the link to a real robot"
    [ testCase "starts the ticks once, when the robot is there" $ do
        started <- newTVarIO (0 :: Int)
        (link, _, _) <- linked (atomically (modifyTVar' started (+ 1)))
        before <- readTVarIO started
        _ <- open link []
        after <- readTVarIO started
        (before, after) @?= (0, 1),
      testCase "has no tick before they are started, and the first one then at once" $
        withClock $ \clock -> do
          readTVarIO (tickDue clock) >>= (@?= False)
          startTicks clock
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

-- | What a program receives after so many seconds in which it did nothing, and its link queued a press and a position.
afterFreeze :: Double -> IO [Message]
afterFreeze seconds = do
  (link, time, queued) <- linked (pure ())
  _ <- open link []
  step <- next link
  for_ step (const (answer link noAnswer))
  atomically (writeTVar time seconds >> writeTVar queued (map Received [press, position]))
  maybe [] batchMessages <$> next link

-- | A link to a robot that is there; its clock, and what the robot sends. A tick is due. The action is 'startTicks' of its clock.
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
