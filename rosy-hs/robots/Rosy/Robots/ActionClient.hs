{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Robots.ActionClient
-- Description : Calls of actions and services over a connection to a robot.
--
-- In: requests of a program. Out: replies among the events of the connection. A robot of ROS 2 behind a rosbridge server gets them as frames; on
-- ROS 1 an action is five topics of actionlib (<http://wiki.ros.org/actionlib/DetailedDescription>). A goal that the connection cannot carry, that no
-- server answers, or that is under way when the robot is lost, is answered with the reason; goals of a program that ends are cancelled.
module Rosy.Robots.ActionClient
  ( ActionCarrier (..),
    withActions,

    -- * Messages of actionlib
    actionTopics,
    goalMessage,
    readActionlib,
    ActionlibMessage (..),
  )
where

import Control.Concurrent (forkIO)
import Control.Concurrent.STM
import Control.Exception (finally)
import Control.Monad (forM_, unless, void, when)
import Data.Aeson (Value (..), object, (.:), (.:?), (.=))
import Data.Aeson.Types (Parser, parseMaybe)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, fromMaybe, isJust, mapMaybe, maybeToList)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as T
import Ros.SlicedTimeout (timeoutInSlices)
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Profile (Variables, expand)
import Rosy.Request
import Rosy.Robots.Connection
import Rosy.Sentence
import Rosy.Topic (pattern OpenAction, pattern OpenMessage)

-- | How a connection carries actions and services.
data ActionCarrier
  = -- | Both as frames to a server of ROS 2.
    FramesOfRos2
  | -- | Actions as topics of ROS 1. The truth says whether services are called by frames.
    TopicsOfActionlib Bool
  | -- | Neither.
    NoCarrier
  deriving (Eq, Show)

-- | What is known of the requests of programs.
data Calls = Calls
  { -- | the goals under way, and the calls of services
    open :: TVar (Map.Map Text Request),
    -- | replies that are made here
    made :: TQueue RobotEvent,
    -- | the actions whose topics are taken, and those of them whose servers have said something
    taken :: TVar (Set.Set Text),
    alive :: TVar (Set.Set Text),
    -- | goals that their servers know, and goals that a server was asked to give up
    known :: TVar (Set.Set Text),
    cancelled :: TVar (Set.Set Text)
  }

-- | A connection that takes requests as well, while an action runs. The variables name the robot's own actions and their types.
withActions :: ActionCarrier -> Variables -> (Connection -> IO a) -> Connection -> IO a
withActions carrier variables use plain = do
  calls <- Calls <$> newTVarIO Map.empty <*> newTQueueIO <*> newTVarIO Set.empty <*> newTVarIO Set.empty <*> newTVarIO Set.empty <*> newTVarIO Set.empty
  let send decided action = case action of
        RequestAction frame -> mapM_ (carryOut carrier variables plain calls) (readRequest frame)
        _ -> sendCommand plain decided action
      -- Its server still says how a goal ended.
      cancelAll = do
        goals <- atomically $ do
          goals <- Map.withoutKeys <$> readTVar (open calls) <*> readTVar (cancelled calls)
          goals <$ modifyTVar' (cancelled calls) (Set.union (Map.keysSet goals))
        sequence_ [carryOut carrier variables plain calls (CancelGoal ident name) | SendGoal ident name _ _ <- Map.elems goals]
      refuse frame why = forM_ (readRequest frame) (atomically . failCall calls why)
  use plain {sendCommand = send, takeEvents = nextEvents plain calls, cancelGoals = cancelAll, refuseCall = refuse} `finally` cancelAll

-- | The events of the connection with the replies among them; none when all were for the client of actions alone.
nextEvents :: Connection -> Calls -> STM [RobotEvent]
nextEvents plain calls = ours `orElse` (takeEvents plain >>= fmap concat . mapM (withReplies calls))
  where
    ours = flushTQueue (made calls) >>= \events -> events <$ check (not (null events))

-- | An event, or what it says of a call.
withReplies :: Calls -> RobotEvent -> STM [RobotEvent]
withReplies calls event = case event of
  Received (ReplyMessage frame) -> maybe (pure []) (uncurry (answered calls frame)) (replyParts frame)
  Received (OpenMessage topic message) -> do
    actions <- readTVar (taken calls)
    case [(action, part) | (action, part) <- [T.breakOnEnd "/" (T.pack topic)], Set.member (T.dropEnd 1 action) actions] of
      (action, part) : _ | Just said <- readActionlib part message -> do
        modifyTVar' (alive calls) (Set.insert (T.dropEnd 1 action))
        case said of
          GoalsKnown ids -> [] <$ modifyTVar' (known calls) (Set.union (Set.fromList ids))
          ActionlibReply ident frame -> do
            modifyTVar' (known calls) (Set.insert ident)
            under <- readTVar (open calls)
            if Map.member ident under then maybe (pure []) (uncurry (answered calls frame)) (replyParts frame) else pure []
      _ -> pure [event]
  Disconnected why -> do
    under <- swapTVar (open calls) Map.empty
    writeTVar (alive calls) Set.empty
    pure (event : [Received (ReplyMessage frame) | request <- Map.elems under, frame <- maybeToList (failedReply request (english why))])
  _ -> pure [event]
  where
    replyParts frame = case frame of
      Object o -> parseMaybe (\x -> (,) <$> x .: "id" <*> x .: "op") o
      _ -> Nothing :: Maybe (Text, Text)

-- | A reply of a server for a call: what ends it is said to a person as well if the server was not reached.
answered :: Calls -> Value -> Text -> Text -> STM [RobotEvent]
answered calls frame ident operation = do
  under <- readTVar (open calls)
  when (operation /= "action_feedback") (writeTVar (open calls) (Map.delete ident under))
  pure (Received (ReplyMessage frame) : catMaybes [Map.lookup ident under >>= failure])
  where
    failure request = case frame of
      Object o | parseMaybe (.: "result") o == Just False -> complaint request (fromMaybe "" (parseMaybe (.: "values") o))
      _ -> Nothing

-- | What a person is told of a call that failed; nothing where the program drives by itself then ("Rosy.Action").
complaint :: Request -> Text -> Maybe RobotEvent
complaint request why = case request of
  SendGoal _ name _ _
    | hasSubstitute name -> Nothing
    | otherwise -> Just (Misunderstood (trWith "the action {action} was not carried out: {why}" ["action" =: name, "why" =: why]))
  CallService _ name _ _ -> Just (Misunderstood (trWith "the service {service} failed: {why}" ["service" =: name, "why" =: why]))
  CancelGoal _ _ -> Nothing

carryOut :: ActionCarrier -> Variables -> Connection -> Calls -> Request -> IO ()
carryOut carrier variables plain calls request = case request of
  SendGoal ident name kind content -> case named name kind of
    Nothing -> failed "the robot has no such action"
    Just (action, of') -> do
      atomically (modifyTVar' (open calls) (Map.insert ident request))
      case carrier of
        NoCarrier -> failed overCable
        FramesOfRos2 -> sendFrame (SendGoal ident action (inRos2 "action" of') content)
        TopicsOfActionlib _ -> pursue plain calls failed ident action (inRos1 of') content
  CancelGoal ident name -> do
    isOpen <- Map.member ident <$> readTVarIO (open calls)
    when isOpen $ case (named name "", carrier) of
      (Just (action, _), FramesOfRos2) -> sendFrame (CancelGoal ident action)
      (Just (action, _), TopicsOfActionlib _) -> sendNow plain (pure [OpenAction (T.unpack action ++ "/cancel") (object ["id" .= ident])])
      _ -> pure ()
  CallService ident name kind content -> do
    atomically (modifyTVar' (open calls) (Map.insert ident request))
    case carrier of
      NoCarrier -> failed overCable
      FramesOfRos2 -> sendFrame (CallService ident name (inRos2 "srv" kind) content)
      TopicsOfActionlib True -> sendFrame (CallService ident name (inRos1 kind) content)
      TopicsOfActionlib False -> failed "services are called through a rosbridge server: ws://HOST:9090"
  where
    sendFrame frame = sendNow plain (pure [RequestAction (requestFrame frame)])
    overCable = "a robot on a serial cable has no actions and services"
    failed why = atomically (failCall calls why request)
    named name kind
      | "/" `T.isPrefixOf` name = Just (name, kind)
      | otherwise = (,) <$> variable name <*> variable (name <> "_type")
    variable name = expand variables . T.pack <$> lookup (T.unpack name) variables

-- | Answers a call with the reason why it is not carried out.
failCall :: Calls -> Text -> Request -> STM ()
failCall calls why request = do
  modifyTVar' (open calls) (Map.delete (identOf request))
  forM_ (failedReply request why) (writeTQueue (made calls) . Received . ReplyMessage)
  mapM_ (writeTQueue (made calls)) (complaint request why)

identOf :: Request -> Text
identOf request = case request of
  SendGoal ident _ _ _ -> ident
  CancelGoal ident _ -> ident
  CallService ident _ _ _ -> ident

-- | @package\/Name@ as ROS 2 writes it, with @action@ or @srv@ in between.
inRos2 :: Text -> Text -> Text
inRos2 between kind = case T.splitOn "/" kind of
  [package, name] -> T.intercalate "/" [package, between, name]
  _ -> kind

-- | The same as ROS 1 writes it.
inRos1 :: Text -> Text
inRos1 kind = case T.splitOn "/" kind of
  [package, _, name] -> package <> "/" <> name
  _ -> kind

-- | Gives a goal to a server of actionlib, as soon as it says that it is there, and again until it knows the goal.
pursue :: Connection -> Calls -> (Text -> IO ()) -> Text -> Text -> Text -> Value -> IO ()
pursue plain calls failed ident action kind content = do
  isTaken <- Set.member action <$> readTVarIO (taken calls)
  missing <- if isTaken then pure [] else registerTopics plain (actionTopics action kind)
  case missing of
    why : _ -> failed (english why)
    [] -> do
      atomically (modifyTVar' (taken calls) (Set.insert action))
      void . forkIO $ do
        isAlive <- await (Set.member action <$> readTVar (alive calls))
        if isAlive then give (3 :: Int) else failedIfOpen "No action server available"
  where
    await condition = isJust <$> timeoutInSlices serverTimeout (atomically (((||) <$> condition <*> (not . Map.member ident <$> readTVar (open calls))) >>= check))
    give left = do
      isOpen <- Map.member ident <$> readTVarIO (open calls)
      when isOpen $ do
        sendNow plain (pure [OpenAction (T.unpack action ++ "/goal") (goalMessage ident content)])
        isKnown <- await (Set.member ident <$> readTVar (known calls))
        unless isKnown (if left > 0 then give (left - 1) else failedIfOpen "The action server does not answer")
    failedIfOpen why = do
      isOpen <- Map.member ident <$> readTVarIO (open calls)
      when isOpen (failed why)

-- | Time for a server of actionlib to say that it is there, or that it knows a goal, microseconds: it says which goals it knows five times a second
-- (actionlib, @action_server_imp.h@: @status_frequency@).
serverTimeout :: Int
serverTimeout = 2000000

-- | The topics of an action of this name and type.
actionTopics :: Text -> Text -> [Topic]
actionTopics action kind =
  [ topic "goal" (kind <> "ActionGoal") Sent,
    topic "cancel" "actionlib_msgs/GoalID" Sent,
    topic "status" "actionlib_msgs/GoalStatusArray" Taken,
    topic "feedback" (kind <> "ActionFeedback") Taken,
    topic "result" (kind <> "ActionResult") Taken
  ]
  where
    topic part of' = Topic (T.unpack (action <> "/" <> part)) (T.unpack of')

-- | A message of the topic @goal@. Without a time the server takes that of its arrival.
goalMessage :: Text -> Value -> Value
goalMessage ident content = object ["goal_id" .= object ["id" .= ident], "goal" .= content]

-- | What a server of actionlib says.
data ActionlibMessage
  = -- | It knows these goals.
    GoalsKnown [Text]
  | -- | A goal, and the frame that says the same of it.
    ActionlibReply Text Value
  deriving (Eq, Show)

-- | A message of the topic @status@, @feedback@ or @result@.
readActionlib :: Text -> Value -> Maybe ActionlibMessage
readActionlib part message = case (part, message) of
  ("status", Object o) -> GoalsKnown . mapMaybe (parseMaybe (\s -> s .: "goal_id" >>= (.: "id"))) <$> parseMaybe (.: "status_list") o
  ("feedback", Object o) -> parseMaybe (reply "feedback") o
  ("result", Object o) -> parseMaybe (reply "result") o
  _ -> Nothing
  where
    reply content o = do
      status <- o .: "status"
      ident <- status .: "goal_id" >>= (.: "id")
      code <- status .: "status" :: Parser Int
      text <- fromMaybe "" <$> status .:? "text"
      values <- o .: content
      let frame more = ActionlibReply ident (object (["op" .= ("action_" <> content), "id" .= ident] ++ more))
      pure $
        if content == "feedback"
          then frame ["values" .= (values :: Value)]
          else frame (ending code text values)
    -- actionlib_msgs, msg/GoalStatus.msg: 2 preempted, 3 succeeded, 4 aborted, 5 rejected, 8 recalled.
    ending code text values = case code of
      3 -> ["values" .= values, "status" .= (4 :: Int), "result" .= True]
      4 -> ["values" .= object ["text" .= text], "status" .= (6 :: Int), "result" .= True]
      5 -> ["values" .= ("Action goal was rejected" <> (if T.null text then "" else ": " <> text)), "status" .= (0 :: Int), "result" .= False]
      _ | code `elem` [2, 8] -> ["values" .= values, "status" .= (5 :: Int), "result" .= True]
      _ -> ["values" .= ("the server has lost the goal" :: Text), "status" .= (0 :: Int), "result" .= False]
