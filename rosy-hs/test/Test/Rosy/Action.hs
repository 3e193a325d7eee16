{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE MultiParamTypeClasses #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Rosy.Action
-- Description : Rule R26 as stories: a goal, its feedback, how it ends, and how it is taken back.
module Test.Rosy.Action (tests) where

import Data.Aeson (Value, object, (.=))
import qualified Data.Aeson.Types as Aeson
import Data.Text (Text, pack)
import GHC.Generics (Generic)
import Rosy hiding (text)
import Rosy.Loop (What)
import Rosy.Program hiding (Value)
import qualified Rosy.Program as Program
import Rosy.Request
import Rosy.Robot
import Support.Story
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit

newtype Count = Count Int deriving (Show, Generic)

newtype Counting = Counting Int deriving (Show, Generic)

newtype Counted = Counted Int deriving (Show, Generic)

instance Program.Value Counting

instance Program.Value Counted

instance Action Count Counting Counted where
  action = actionServer "/count" "my/Count" (\(Count n) -> [("order", whole n)]) (Counting <$> field "at") (Counted <$> field "sum")

instance Service Count Counted where
  service = serviceServer "/sum" "my/Sum" (\(Count n) -> [("order", whole n)]) (Counted <$> field "sum")

-- | A frame of the server for the first call of a program, or for another one.
frame :: Text -> Text -> [Aeson.Pair] -> What
frame op ident more = sensed (ReplyMessage (object (["op" .= op, "id" .= ident] ++ more)))

result :: Int -> [Aeson.Pair] -> What
result status more = frame "action_result" firstCall (["status" .= status, "result" .= True] ++ more)

values :: [Aeson.Pair] -> [Aeson.Pair]
values pairs = ["values" .= object pairs]

failed :: Text -> What
failed why = frame "action_result" firstCall ["status" .= (0 :: Int), "result" .= False, "values" .= why]

-- | The identifier comes from the seed of the run, which a story does not change.
firstCall :: Text
firstCall = pack ident

ident :: String
ident = case map words (commandsOf (callAction (Count 3)) [at 0 ticked]) of
  [_, _, _, found] : _ -> found
  _ -> ""

outcomes :: What -> [String]
outcomes reply = filter (/= goal) (commandsOf (callAction (Count 3) >>= say . show) [at 0 ticked, at 0.1 reply])

goal :: String
goal = "Request send_action_goal /count " ++ ident

tests :: TestTree
tests =
  testGroup
    "Action"
    [ testCase "the goal is sent at once, and waits for its own result" $
        told (callAction (Count 3) >>= say . show) [at 0 ticked, at 0.1 (frame "action_result" "rosy-1" (("status" .= (4 :: Int)) : values ["sum" .= (1 :: Int)])), at 0.2 (result 4 (values ["sum" .= (6 :: Int)]))]
          @?= [(0, goal), (0.2, "Say \"Succeeded (Counted 6)\"")],
      testCase "how it ends is a value" $
        map outcomes [result 5 (values []), result 6 (values ["text" .= ("stuck" :: Text)]), failed "Action goal was rejected", failed "No action server available"]
          @?= [["Say \"Cancelled\""], ["Say \"Aborted \\\"stuck\\\"\""], ["Say \"Rejected \\\"Action goal was rejected\\\"\""], ["Say \"Unavailable \\\"No action server available\\\"\""]],
      testCase "a trace says in words what a server replied" $
        map
          shownReply
          [ object ["op" .= ("action_feedback" :: Text), "action" .= ("dock" :: Text), "id" .= ident],
            object ["op" .= ("action_result" :: Text), "action" .= ("dock" :: Text), "id" .= ident, "status" .= (4 :: Int), "result" .= True],
            object ["op" .= ("action_result" :: Text), "action" .= ("dock" :: Text), "id" .= ident, "status" .= (6 :: Int), "result" .= True, "values" .= object ["text" .= ("stuck" :: Text)]],
            object ["op" .= ("action_result" :: Text), "action" .= ("navigate_to" :: Text), "id" .= ident, "status" .= (6 :: Int), "result" .= True, "values" .= object ["error_code" .= (204 :: Int), "error_msg" .= ("" :: Text)]],
            object ["op" .= ("action_result" :: Text), "action" .= ("/count" :: Text), "id" .= ident, "status" .= (0 :: Int), "result" .= False, "values" .= ("No action server available" :: Text)],
            object ["op" .= ("service_response" :: Text), "service" .= ("/sum" :: Text), "id" .= ident, "result" .= True]
          ]
          @?= ["Reply dock Feedback", "Reply dock Succeeded", "Reply dock Aborted stuck", "Reply navigate_to Aborted error 204", "Reply /count Unavailable No action server available", "Reply /sum Succeeded"],
      testCase "it tells how far it is" $
        filter (/= goal) (commandsOf (task (call (callAction (Count 3)) callOptions {onFeedback = \(Counting n) -> Say (show n)}) (\(Button _ _) -> Done ())) [at 0 ticked, at 0.1 (frame "action_feedback" firstCall (values ["at" .= (2 :: Int)]))])
          @?= ["Say \"2\""],
      testCase "losing a race takes the goal back, reaching it does not" $
        ( told (race (wait 1) (callAction (Count 3))) [at 0 ticked, at 1 ticked],
          told (race (wait 1) (callAction (Count 3))) [at 0 ticked, at 0.5 (result 4 (values ["sum" .= (6 :: Int)]))]
        )
          @?= ([(0, goal), (1, "Request cancel_action_goal /count " ++ ident)], [(0, goal)]),
      testCase "a service is a task as well" $
        told (callService (Count 3) >>= say . show) [at 0 ticked, at 0.1 (frame "service_response" firstCall (("result" .= True) : values ["sum" .= (6 :: Int)]))]
          @?= [(0, "Request call_service /sum " ++ ident), (0.1, "Say \"Succeeded (Counted 6)\"")],
      testCase "what the robot has no action for the language does" $
        take 2 (commandsOf (driveDistance 0.5) [at 0 still, at 0.02 (failed "the robot has no such action"), at 0.04 still])
          @?= ["Request send_action_goal drive_distance " ++ ident, "Velocity 0.3 0.0"],
      testCase "a frame is read as it is written" $
        let requests = [SendGoal "a" "/b" "c/D" (object []), CancelGoal "a" "/b", CallService "a" "/b" "c/D" (object [])]
         in map (readRequest . requestFrame) requests @?= map Just requests
    ]
