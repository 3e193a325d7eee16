{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Test.Robots.ActionClient
-- Description : Calls of actions and services over a connection that is none.
module Test.Robots.ActionClient (tests) where

import Control.Concurrent.STM
import Data.Aeson (Value, object, withObject, (.:), (.=))
import Data.Aeson.Types (parseMaybe)
import Data.Text (Text)
import Rosy.Channel (Action)
import Rosy.Request
import Rosy.Robots.ActionClient
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.UnreadableMessages (noneUnreadable)
import Rosy.Sentence (verbatim)
import Rosy.Topic (pattern OpenAction, pattern OpenMessage)
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "actions and services"
    [ testCase "on ROS 2 a goal is a frame, with the type as ROS 2 writes it and the name of the robot's description" $ do
        (sent, _) <- calling FramesOfRos2 (\robot _ _ -> sendCommand robot 0 (request dock))
        sent @?= [request (SendGoal "rosy-1" "/robot1/dock" "irobot_create_msgs/action/Dock" (object [])), request (CancelGoal "rosy-1" "/robot1/dock")],
      testCase "what the robot does not have, and a cable, are answered" $ do
        (sent, heard) <- calling FramesOfRos2 (\robot _ _ -> sendCommand robot 0 (request (SendGoal "rosy-1" "undock" "" (object []))))
        (sent, answers heard) @?= ([], [unavailable "undock" "the robot has no such action"])
        (none, told) <- calling NoCarrier (\robot _ _ -> sendCommand robot 0 (request (CallService "rosy-2" "/add" "my/Add" (object []))))
        (none, length (answers told), length told) @?= ([], 1, 2),
      testCase "a robot that is lost answers what is under way" $ do
        (_, heard) <- calling FramesOfRos2 (\robot arrive _ -> sendCommand robot 0 (request dock) >> arrive (Disconnected (verbatim "gone")))
        answers heard @?= [unavailable "dock" "gone"],
      testCase "on ROS 1 a goal waits for its server, and is five topics" $ do
        (sent, heard) <- calling (TopicsOfActionlib True) $ \robot arrive sentSoFar -> do
          sendCommand robot 0 (request count)
          arrive (Received (OpenMessage "/count/status" (object ["status_list" .= ([] :: [Value])])))
          -- The server's status is for the client alone.
          nothing <- eventsOf robot
          nothing @?= []
          atomically (sentSoFar >>= check . not . null)
          arrive (Received (OpenMessage "/count/result" (actionlib 3 "" (object ["sum" .= (6 :: Int)]))))
        [message | OpenAction "/count/goal" message <- sent] @?= [goalMessage "rosy-1" (object ["order" .= (3 :: Int)])]
        answers heard @?= [object ["op" .= ("action_result" :: Text), "id" .= ("rosy-1" :: Text), "values" .= object ["sum" .= (6 :: Int)], "status" .= (4 :: Int), "result" .= True]],
      testCase "what is said of a goal on ROS 1" $
        [parseMaybe (withObject "a frame" (\o -> (,) <$> o .: "status" <*> o .: "result")) frame | code <- [2, 4, 5, 8, 9], Just (ActionlibReply _ frame) <- [readActionlib "result" (actionlib code "why" (object []))]]
          @?= map Just [(5 :: Int, True), (6, True), (0, False), (5, True), (0, False)],
      testCase "a robot that may not drive is given no goal; one is taken back" $
        ([callsServer (request r) | r <- [dock, CallService "a" "/b" "c/D" (object []), CancelGoal "a" "/b"]], mayBeDriven (newGuard (Limits 0.7 pi Nothing) False))
          @?= ([Just (requestFrame dock), Just (requestFrame (CallService "a" "/b" "c/D" (object []))), Nothing], False)
    ]

dock, count :: Request
dock = SendGoal "rosy-1" "dock" "" (object [])
count = SendGoal "rosy-1" "/count" "my/Count" (object ["order" .= (3 :: Int)])

request :: Request -> Action
request = RequestAction . requestFrame

unavailable :: Text -> Text -> Value
unavailable name why = object ["op" .= ("action_result" :: Text), "id" .= ("rosy-1" :: Text), "action" .= name, "values" .= why, "status" .= (0 :: Int), "result" .= False]

actionlib :: Int -> Text -> Value -> Value
actionlib code text result = object ["status" .= object ["goal_id" .= object ["id" .= ("rosy-1" :: Text)], "status" .= code, "text" .= text], "result" .= result]

answers :: [RobotEvent] -> [Value]
answers events = [frame | Received (ReplyMessage frame) <- events]

-- | The events that there are now.
eventsOf :: Connection -> IO [RobotEvent]
eventsOf robot = atomically (takeEvents robot `orElse` pure [])

-- | What a robot was sent and what was heard of it, while an action runs. It gets the connection, what lets an event arrive, and what was sent so far.
calling :: ActionCarrier -> (Connection -> (RobotEvent -> IO ()) -> STM [Action] -> IO ()) -> IO ([Action], [RobotEvent])
calling carrier play = do
  sent <- newTVarIO []
  queue <- newEventQueue
  let variables = [("prefix", "/robot1"), ("dock", "{prefix}/dock"), ("dock_type", "irobot_create_msgs/Dock")]
      plain =
        Connection
          { connectionName = verbatim "here",
            connectionRoutes = [],
            registerTopics = const (pure []),
            sendCommand = \_ a -> atomically (modifyTVar' sent (a :)),
            cancelGoals = pure (),
            refuseCall = \_ _ -> pure (),
            takeEvents = awaitEvents queue,
            unreadableMessages = pure noneUnreadable,
            velocityTopic = pure Nothing
          }
      again robot before = eventsOf robot >>= \events -> if null events then pure before else again robot (before ++ events)
  heard <- withActions carrier variables (\robot -> play robot (atomically . enqueue queue) (readTVar sent) >> again robot []) plain
  told <- readTVarIO sent
  pure (reverse told, heard)
