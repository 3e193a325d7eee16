{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE ViewPatterns #-}

-- |
-- Module      : Rosy.Request
-- Description : Calls of actions and services on their way to a robot, and the replies.
--
-- All links carry them on two channels, one for each direction, as frames of rosbridge v2 (rosbridge v2.0 Protocol Specification, 3.2.12 to 3.2.15 and
-- 3.3.8 to 3.3.9). An action whose name has no slash is one that the robot's description names. "Rosy.Action" makes tasks of them.
module Rosy.Request
  ( -- * Channels
    pattern RequestAction,
    pattern ReplyMessage,
    replyChannel,

    -- * Frames
    Request (..),
    readRequest,
    requestFrame,
    isReply,
    shownReply,
    replyEnding,
    callPrefix,
    failedReply,
    hasSubstitute,
  )
where

import Control.Monad ((<=<))
import Data.Aeson (Value (..), object, parseJSON, (.:), (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (Parser, parseMaybe)
import Data.List (find)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Channel (Action (..), Channel (..), Field (Structure), Kind (..), Message (..))
import Rosy.Core (replyChannelNumber)
import Rosy.Outcome

-- | What programs send, and what they receive.
requestChannel, replyChannel :: Channel
requestChannel = Channel (replyChannelNumber + 2) "Request" CommandChannel 0 Nothing (shownRequest <=< onlyFrame)
replyChannel = Channel replyChannelNumber "Reply" EventChannel 0 Nothing (fmap shownReply . onlyFrame)

onlyFrame :: [Field] -> Maybe Value
onlyFrame fields = case fields of
  [Structure frame] -> Just frame
  _ -> Nothing

-- | A request as a trace shows it: its operation, whom it concerns, and its identifier.
shownRequest :: Value -> Maybe String
shownRequest frame = case frame of
  Object o -> Just (unwords ("Request" : [Text.unpack t | key <- ["op", "action", "service", "id"], Just (String t) <- [KeyMap.lookup key o]]))
  _ -> Nothing

-- | A reply as traces and the page show it: who replies, how the call goes on, and why: @Reply dock Aborted no dock is in sight.@
shownReply :: Value -> String
shownReply frame = unwords (["Reply"] ++ names ++ [answer] ++ [why | why <- [reason], not (null why)])
  where
    names = case frame of
      Object o -> [Text.unpack t | key <- ["action", "service"], Just (String t) <- [KeyMap.lookup key o]]
      _ -> []
    (answer, reason) = case replyEnding frame of
      Nothing -> ("Feedback", "")
      Just (Succeeded ()) -> ("Succeeded", "")
      Just (Rejected why) -> ("Rejected", why)
      Just (Aborted why) -> ("Aborted", why)
      Just Cancelled -> ("Cancelled", "")
      Just (Unavailable why) -> ("Unavailable", why)

-- | How a call ended, by its last reply; none for feedback. The status is that of ROS 2 (action_msgs\/msg\/GoalStatus): 5 cancelled, 6 aborted;
-- rosbridge_suite says in words why a goal was not pursued (@rosbridge_library\/internal\/actions.py@).
replyEnding :: Value -> Maybe (Outcome ())
replyEnding frame = case frame of
  Object o
    | is "op" "action_feedback" o -> Nothing
    | Just (Bool False) <- KeyMap.lookup "result" o -> Just ((if "rejected" `Text.isInfixOf` why o then Rejected else Unavailable) (Text.unpack (why o)))
    | otherwise -> Just $ case KeyMap.lookup "status" o >>= parseMaybe parseJSON of
      Just (5 :: Int) -> Cancelled
      Just 6 -> Aborted (Text.unpack (reason o))
      _ -> Succeeded ()
  _ -> Nothing
  where
    is key value o = KeyMap.lookup key o == Just (String value)
    why o = textOf (KeyMap.lookup "values" o)
    -- Docking as ROS 1 knows it (AutoDocking) has a text; nav2_msgs/NavigateToPose an error message, before ROS 2 Kilted only a number.
    reason o = case KeyMap.lookup "values" o of
      Just (Object values) -> fromMaybe "" (find (not . Text.null) ([textOf (KeyMap.lookup key values) | key <- ["text", "error_msg"]] ++ [numbered n | Just (Number n) <- [KeyMap.lookup "error_code" values], n /= 0]))
      _ -> ""
    numbered n = "error " <> Text.pack (show (truncate n :: Int))
    textOf found = case found of
      Just (String t) -> t
      _ -> ""

-- | A frame of rosbridge v2 that a program sends: @send_action_goal@, @cancel_action_goal@ or @call_service@.
pattern RequestAction :: Value -> Action
pattern RequestAction frame <-
  Action ((== requestChannel) -> True) [Structure frame]
  where
    RequestAction frame = Action requestChannel [Structure frame]

-- | A frame of rosbridge v2 that answers one: @action_feedback@, @action_result@ or @service_response@.
pattern ReplyMessage :: Value -> Message
pattern ReplyMessage frame <-
  Message ((== replyChannel) -> True) [Structure frame]
  where
    ReplyMessage frame = Message replyChannel [Structure frame]

-- | A request by its parts: identifier, name and type of the server, and the content.
data Request
  = SendGoal Text Text Text Value
  | -- | Identifier and name.
    CancelGoal Text Text
  | CallService Text Text Text Value
  deriving (Eq, Show)

-- | The frame of a request.
requestFrame :: Request -> Value
requestFrame request = object $ case request of
  SendGoal ident name kind content -> ["op" .= ("send_action_goal" :: Text), "id" .= ident, "action" .= name, "action_type" .= kind, "args" .= content, "feedback" .= True]
  CancelGoal ident name -> ["op" .= ("cancel_action_goal" :: Text), "id" .= ident, "action" .= name]
  CallService ident name kind content -> ["op" .= ("call_service" :: Text), "id" .= ident, "service" .= name, "type" .= kind, "args" .= content]

-- | The parts of a request's frame.
readRequest :: Value -> Maybe Request
readRequest frame = case frame of
  Object o -> parseMaybe parts o
  _ -> Nothing
  where
    parts o = do
      op <- o .: "op" :: Parser Text
      case op of
        "send_action_goal" -> SendGoal <$> o .: "id" <*> o .: "action" <*> o .: "action_type" <*> o .: "args"
        "cancel_action_goal" -> CancelGoal <$> o .: "id" <*> o .: "action"
        "call_service" -> CallService <$> o .: "id" <*> o .: "service" <*> o .: "type" <*> o .: "args"
        _ -> fail "no request"

-- | How the identifiers of programs' calls begin.
callPrefix :: Text
callPrefix = "rosy-"

-- | Whether an operation is one of a reply.
isReply :: Text -> Bool
isReply = (`elem` ["action_feedback", "action_result", "service_response"])

-- | The actions of robots in whose place a program drives by itself ("Rosy.Action").
hasSubstitute :: Text -> Bool
hasSubstitute = (`elem` ["undock", "drive_distance", "rotate_angle"])

-- | The reply to a request that cannot be carried out, with the reason; none to a cancellation.
failedReply :: Request -> Text -> Maybe Value
failedReply request why = case request of
  SendGoal ident name _ _ -> Just (object ["op" .= ("action_result" :: Text), "id" .= ident, "action" .= name, "values" .= why, "status" .= (0 :: Int), "result" .= False])
  CallService ident name _ _ -> Just (object ["op" .= ("service_response" :: Text), "id" .= ident, "service" .= name, "values" .= why, "result" .= False])
  CancelGoal _ _ -> Nothing
