{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Link.Ros
-- Description : A robot on ROS 1.
--
-- In: the address of the master and the names of the base's topics. Out: a 'Connection' while an action runs: the program is
-- a ROS node called @/rosy@. The robot is connected when its odometry arrives and it has subscribed to commands, and lost when
-- odometry has no publisher or was missing for a second. A newer node of the same name takes over the robot.
module Rosy.Link.Ros
  ( withRos,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM
import Control.Monad (forM_, unless, when)
import qualified Data.Aeson as Aeson
import Data.Aeson.Encoding (encodingToLazyByteString)
import Data.Foldable (toList)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isNothing)
import Data.Proxy (Proxy)
import qualified Data.Set as Set
import qualified Data.Text as T
import Data.Time.Clock.POSIX (getPOSIXTime)
import GHC.TypeLits (SomeSymbol (..), someSymbolVal)
import Ros.Message (RosBinary (put))
import qualified Ros.Net.Master as Master
import Ros.Net.Tcpros (frame)
import Ros.Node hiding (Topic)
import Ros.Node.Core (master)
import Ros.SlicedTimeout (timeoutInSlices)
import qualified Ros.Topic as Ros
import Rosy.Channel (Action (..), Channel (..), Field, Message)
import Rosy.Codec
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Robot
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.Connection
import Rosy.Robots.DynamicMessage
import Rosy.Robots.Expiry
import Rosy.Robots.Guardian (guardingSocket, lastHeartbeat, newHeartbeats)
import Rosy.Robots.RosbridgeCodec (strangeVelocity, velocityAt, velocityRoute)
import Rosy.Robots.Target (odometryTopic)
import Rosy.Robots.UnreadableMessages (Unreadable (..))
import Rosy.Sentence
import Rosy.Topic (pattern OpenAction, pattern OpenMessage)

-- | The truth says whether the master is asked for the type of the velocity topic.
withRos :: Settings -> Sentence -> Bool -> [Route] -> (Connection -> IO a) -> IO a
withRos settings name asksType plain use = withNodeIn settings "rosy" $ do
  hearing <- liftIO newEventQueue
  known <- if asksType then namedRoutes hearing plain else pure plain
  presence <- liftIO (Presence hearing <$> newTVarIO False <*> newTVarIO 0 <*> newTVarIO False)
  own <- liftIO (OwnTopics <$> newTVarIO Set.empty <*> newTVarIO Map.empty)
  let isOdometry r = routeChannel r == odometryChannel
      taking carried arrival = receive carried (atomically . enqueueUnreadable hearing) arrival (takeOwn hearing own carried)
  forM_ (sensorTopics (described known)) $ \carried ->
    unless (any isOdometry carried) (taking carried (atomically . enqueue hearing . Received))
  publishers <- Map.fromList <$> mapM (\r -> (,) (channelNumber (routeChannel r)) <$> sender r) (described (commandRoutes known))
  -- The first sound of a program would be lost on a base whose odometry comes a moment before it has connected to ours.
  forM_ (filter (any isOdometry) (sensorTopics known)) $ \carried -> nodeIO (\run -> run (taking carried (odometryArrives presence (run (awaitListeners listenerTimeout)))))
  ownTopics <- nodeIO (\run -> pure (run . fmap concat . mapM (registerOwn hearing own known)))
  let connection =
        Connection
          { connectionName = name,
            connectionRoutes = known,
            registerTopics = ownTopics,
            sendCommand = \decided -> \case
              OpenAction topic message -> readTVarIO (sent own) >>= mapM_ ($ message) . Map.lookup topic
              a@(Action c _) -> forM_ (Map.lookup (channelNumber c) publishers) ($ expiring decided a),
            cancelGoals = pure (),
            refuseCall = \_ _ -> pure (),
            takeEvents = awaitEvents hearing,
            unreadableMessages = unreadableSoFar hearing,
            velocityTopic = pure (fmap (\r -> (routeTopic r, routeType r)) (routeFor known velocityChannel))
          }
  core <- askCore
  let missing = reportMissing presence (Master.hasParam (master core) "/run_id") (odometryTopic known)
  nodeIO $ \run ->
    withAsync (watchSilence presence) $ \_ -> withAsync (missing unknownReason) $ \_ ->
      withAsync (run awaitEnd >>= atomically . enqueue hearing . Disconnected . because) (const (use connection))
  where
    because why = case why of
      AskedTo reason -> verbatim (T.pack reason)
      _ -> tr "this node ended"

-- | Routes whose messages are described.
described :: [Route] -> [Route]
described = filter (hasDefinition . T.unpack . routeType)

-- * Whether the robot is there

-- | What odometry tells of the robot.
data Presence = Presence
  { events :: EventQueue,
    -- | whether odometry has arrived since the robot was lost
    heard :: TVar Bool,
    -- | messages of odometry so far
    count :: TVar Int,
    -- | whether the robot is connected
    present :: TVar Bool
  }

-- | Takes a message of odometry. The first connects the robot, after an action that waits for its listeners.
odometryArrives :: Presence -> IO () -> Message -> IO ()
odometryArrives presence listening o = do
  there <- readTVarIO (present presence)
  atomically (writeTVar (heard presence) True)
  unless there listening
  atomically $ do
    wasPresent <- swapTVar (present presence) True
    unless wasPresent (enqueue (events presence) Connected)
    modifyTVar' (count presence) (+ 1)
    enqueue (events presence) (Received o)

-- | Reports a connected robot as lost when its odometry stops.
watchSilence :: Presence -> IO ()
watchSilence presence = do
  -- Only a connected robot can be lost.
  atomically (readTVar (present presence) >>= check)
  before <- readTVarIO (count presence)
  came <- timeoutInSlices silenceTimeout (atomically (readTVar (count presence) >>= check . (/= before)))
  when (isNothing came) . atomically $ do
    writeTVar (present presence) False
    writeTVar (heard presence) False
    enqueue (events presence) (Disconnected (tr "nothing was heard of it for a second"))
  watchSilence presence

-- | Until the robot is there: reports what it waits for. Takes a question to the master, the topic of odometry, and what was reported last.
reportMissing :: Presence -> IO (Either failure Bool) -> String -> Sentence -> IO ()
reportMissing presence askMaster topic told = do
  threadDelay silenceTimeout
  -- Odometry may arrive while the listeners are waited for.
  there <- readTVarIO (heard presence)
  answer <- if there then pure Nothing else Just <$> askMaster
  let why = case answer of
        Nothing -> unknownReason
        Just (Left _) -> tr "no ROS master answers; does roscore run there?"
        Just (Right _) -> trWith "the ROS master answers and no node publishes odometry as {topic}; does the base's own program run?" ["topic" =: T.pack topic]
  when (why /= told && why /= unknownReason) (atomically (enqueue (events presence) (Disconnected why)))
  reportMissing presence askMaster topic why

-- * Topics of programs

-- | The topics of the program's own: those that are taken, and the publishers of those that are sent.
data OwnTopics = OwnTopics {taken :: TVar (Set.Set String), sent :: TVar (Map.Map String (Aeson.Value -> IO ()))}

-- | Takes a message of the robot's channels for the program as well, if it has asked for the topic.
takeOwn :: EventQueue -> OwnTopics -> NonEmpty Route -> Aeson.Value -> IO ()
takeOwn hearing own (first :| _) v = do
  let topic = T.unpack (routeTopic first)
  isTaken <- Set.member topic <$> readTVarIO (taken own)
  when isTaken (atomically (enqueue hearing (Received (OpenMessage topic v))))

-- | Subscribes to a topic of the program's own, or publishes it. The result says why that cannot be.
registerOwn :: EventQueue -> OwnTopics -> [Route] -> Topic -> Node [Sentence]
registerOwn hearing own known t
  | not (hasDefinition (topicType t)) = pure [trWith "There is no description of the message {message}, which {topic} has. Put its .msg file in a folder of ROSY_MSG_PATH." ["message" =: T.pack (topicType t), "topic" =: T.pack (topicName t)]]
  | topicUse t == Taken = do
    isNew <- liftIO . atomically $ do
      before <- readTVar (taken own)
      writeTVar (taken own) (Set.insert (topicName t) before)
      pure (Set.notMember (topicName t) before && T.pack (topicName t) `notElem` map routeTopic (described (sensorRoutes known)))
    [] <$ when isNew (receiveOwn t (atomically . enqueue hearing . Received . OpenMessage (topicName t)))
  | T.pack (topicName t) `elem` map routeTopic (commandRoutes known) = pure []
  | otherwise = do
    before <- liftIO (readTVarIO (sent own))
    [] <$ unless (Map.member (topicName t) before) (senderOwn t >>= \s -> liftIO (atomically (modifyTVar' (sent own) (Map.insert (topicName t) s))))

-- * Messages and the master

-- | Time without a message after which the robot counts as lost, microseconds: fifty odometry messages are missing.
silenceTimeout :: Int
silenceTimeout = 1000000

-- | Time for the subscribers of commands to connect, microseconds: as long as a call between nodes may take ("Ros.Net.Rpc").
listenerTimeout :: Int
listenerTimeout = 5000000

-- | The routes with the topic and the type of velocities that the master names; those of the robot's description where it knows none.
namedRoutes :: EventQueue -> [Route] -> Node [Route]
namedRoutes hearing plain = do
  core <- askCore
  types <- liftIO (Master.topicTypes (master core))
  let asked = Map.fromList [(T.pack topic, Just (T.pack kind)) | Right found <- [types], (topic, kind) <- found]
      named r
        | routeChannel r /= velocityChannel = pure r
        | otherwise = case velocityRoute asked r of
          Left kind -> r <$ atomically (enqueue hearing (Misunderstood (strangeVelocity (routeTopic r) kind)))
          Right found -> pure (fromMaybe r found)
  liftIO (mapM named plain)

-- | Runs an action on every message of the channels of a topic, another on what fits none of them, and a third on the whole message.
receive :: NonEmpty Route -> (Unreadable -> IO ()) -> (Message -> IO ()) -> (Aeson.Value -> IO ()) -> Node ()
receive carried@(r :| _) strange use whole = case someSymbolVal (T.unpack (routeType r)) of
  SomeSymbol (_ :: Proxy name) -> do
    arriving <- subscribe (T.unpack (routeTopic r)) :: Node (Ros.Topic IO (DynamicMessage name))
    runHandler_ (\(DynamicMessage v) -> either (strange . Unreadable (routeTopic r) . T.pack) (mapM_ use) (readMessages (toList carried) (routeTopic r) v) >> whole v) arriving

-- | Runs an action on every message of a topic of the program's own.
receiveOwn :: Topic -> (Aeson.Value -> IO ()) -> Node ()
receiveOwn t use = case someSymbolVal (topicType t) of
  SomeSymbol (_ :: Proxy name) -> do
    arriving <- subscribe (topicName t) :: Node (Ros.Topic IO (DynamicMessage name))
    runHandler_ (\(DynamicMessage v) -> use v) arriving

-- | What publishes the messages of a topic of the program's own. Latched, so that a listener that connects later gets the last one.
senderOwn :: Topic -> Node (Aeson.Value -> IO ())
senderOwn t = case someSymbolVal (topicType t) of
  SomeSymbol (_ :: Proxy name) -> do
    publisher' <- publisherWith publisherOptions {latched = True} (topicName t) :: Node (Publisher (DynamicMessage name))
    pure (publish publisher' . DynamicMessage)

-- | What publishes the commands of a channel.
sender :: Route -> Node (Expiring Action -> IO ())
sender r = case someSymbolVal (T.unpack (routeType r)) of
  SomeSymbol (_ :: Proxy name) -> do
    heartbeats <- liftIO newHeartbeats
    let messageAt time = Aeson.decode . encodingToLazyByteString . velocityAt r time . encode r :: [Field] -> Maybe Aeson.Value
        Action wheels atRest = VelocityCommand (Velocity 0 0)
        -- Each base that listens to velocities has a guardian.
        guarded socket = case messageAt 0 atRest of
          Just stop | routeChannel r == wheels -> guardingSocket heartbeats socket (frame (put (DynamicMessage stop :: DynamicMessage name)))
          _ -> id
    publisher' <- publisherWith publisherOptions {latched = routeLatched r, aroundSubscriber = guarded} (T.unpack (routeTopic r)) :: Node (Publisher (DynamicMessage name))
    pure $ \command -> do
      now <- getPOSIXTime
      forM_ (traverse (\(Action _ fields) -> DynamicMessage <$> messageAt (realToFrac now) fields) command) $ \message ->
        publishPicked publisher' (\e -> (\heartbeat t -> valueAt heartbeat t e) <$> lastHeartbeat heartbeats <*> bootSeconds) message
