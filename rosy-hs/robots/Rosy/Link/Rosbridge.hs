{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Link.Rosbridge
-- Description : A robot behind a rosbridge server.
--
-- In: the address of the server and the names of the base's topics. Out: a 'Connection' while an action runs. A thread
-- connects, and again whenever the connection is lost; the robot is connected when its odometry arrives and the server was asked which type of
-- velocities it takes, and lost when nothing has arrived for a second. Topics that should say something and are silent are subscribed again.
module Rosy.Link.Rosbridge
  ( withRosbridge,
  )
where

import Control.Concurrent (threadDelay, threadWaitWrite)
import Control.Concurrent.Async (race, race_, withAsync)
import Control.Concurrent.STM
import Control.Exception (Handler (..), IOException, bracket, catches, finally)
import Control.Monad (forM_, forever, void, when)
import qualified Data.ByteString.Lazy as L
import Data.IORef
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as T
import Data.Time.Clock.POSIX (getPOSIXTime)
import Network.Socket (close, withFdSocket)
import qualified Network.WebSockets as WS
import Ros.Net.Rpc (connectTo)
import Ros.SlicedTimeout (delayInSlices, timeoutInSlices)
import Rosy.Channel (Channel (..), Kind (..))
import Rosy.Codec
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Robot (velocityChannel, pattern OdometryMessage)
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.Connection
import Rosy.Robots.ConnectionError (explainConnectionError)
import Rosy.Robots.Expiry
import Rosy.Robots.Guardian (Heartbeats, guardingSocket, lastHeartbeat, newHeartbeats)
import Rosy.Robots.RosbridgeCodec
import Rosy.Robots.Target
import Rosy.Sentence
import System.Posix.Types (Fd (..))

-- | The truth says whether the server is asked for the type of the velocity topic.
withRosbridge :: String -> Int -> String -> Bool -> [Route] -> (Connection -> IO a) -> IO a
withRosbridge host port path asksType known use = do
  held <- newTVarIO nothingHeld
  link <- Link known asksType <$> newEventQueue <*> newTQueueIO <*> newTVarIO False <*> newTVarIO [] <*> newTVarIO noLevels <*> newTVarIO known <*> newTVarIO 0 <*> newHeartbeats
  let connection =
        Connection
          { connectionName = trWith "the robot at {address}" ["address" =: T.pack ("ws://" ++ host ++ ":" ++ show port ++ path)],
            connectionRoutes = known,
            registerTopics = \topics -> do
              atomically $ do
                before <- readTVar (ownTopics link)
                let new = filter (`notElem` before) topics
                writeTVar (ownTopics link) (before ++ new)
                isConnected <- readTVar (isOpen link)
                when isConnected (mapM_ (writeFrame link) (topicFrames new))
              pure [],
            sendCommand = \decided a -> do
              now <- getPOSIXTime
              atomically $ do
                routes' <- readTVar (currentRoutes link)
                time <- (realToFrac now +) <$> readTVar (clockOffset link)
                frame <- traverse (stateTVar held . encodeCommand routes' time) (expiring decided a)
                isConnected <- readTVar (isOpen link)
                when isConnected (writeTQueue (outgoing link) (Just frame)),
            cancelGoals = pure (),
            refuseCall = \_ _ -> pure (),
            takeEvents = awaitEvents (hearing link),
            unreadableMessages = unreadableSoFar (hearing link),
            velocityTopic = fmap (\r -> (routeTopic r, routeType r)) . (`routeFor` velocityChannel) <$> readTVar (currentRoutes link)
          }
      -- What was told last, a stop, is to arrive: the base would notice the silence only 0.6 s later. The server answers a goodbye
      -- behind it; a connection that is closed with odometry unread takes along what is still under way.
      goodbye = do
        atomically (readTVar (isOpen link) >>= \c -> when c (writeTQueue (outgoing link) Nothing))
        timeoutInSlices flushTimeout (atomically (readTVar (isOpen link) >>= check . not))
  withAsync (keepConnected host port path link) $ \_ -> use connection `finally` goodbye

-- | Half a second, in microseconds.
flushTimeout :: Int
flushTimeout = 500000

-- | Time without a message after which the robot counts as lost, microseconds: fifty odometry messages are missing.
silenceTimeout :: Int
silenceTimeout = 1000000

-- | What the threads of a connection share.
data Link = Link
  { -- | the routes before the server was asked
    plainRoutes :: [Route],
    asksVelocityType :: Bool,
    hearing :: EventQueue,
    -- | frames to send; nothing ends the connection. A robot without wheels has no frame for a velocity
    outgoing :: TQueue (Maybe (Expiring (Maybe L.ByteString))),
    isOpen :: TVar Bool,
    -- | topics of the program's own
    ownTopics :: TVar [Topic],
    levels :: TVar Levels,
    -- | with the topic and type of velocities that the server has named; without velocities until the robot may be driven
    currentRoutes :: TVar [Route],
    -- | what the robot's clock is ahead of ours by, seconds, as its odometry says
    clockOffset :: TVar Double,
    heartbeats :: Heartbeats
  }

keepConnected :: String -> Int -> String -> Link -> IO ()
keepConnected host port path link = go firstPause unknownReason
  where
    go pause said = do
      why <- (runConnection >> pure (tr "the connection ended")) `catches` [Handler (\e -> pure (explainConnectionError (e :: IOException))), Handler (\e -> pure (ended (e :: WS.ConnectionException))), Handler (\(_ :: WS.HandshakeException) -> pure (tr "what listens there is no rosbridge server"))]
      wasConnected <- atomically (swapTVar (isOpen link) False <* flushTQueue (outgoing link))
      if wasConnected || why /= said then atomically (enqueue (hearing link) (Disconnected why)) else pure ()
      threadDelay pause
      go (if wasConnected then firstPause else min lastPause (pause * 2)) why
    runConnection = bracket (connectTo host port) close $ \s ->
      WS.runClientWithSocket s (host ++ ":" ++ show port) path WS.defaultConnectionOptions [] $ \c -> do
        forM_ (advertiseFrames (filter (not . isVelocity) (plainRoutes link)) ++ subscribeFrames (plainRoutes link)) (WS.sendTextData c)
        topics <- atomically (writeTVar (currentRoutes link) (filter (not . isVelocity) (plainRoutes link)) >> writeTVar (isOpen link) True >> readTVar (ownTopics link))
        forM_ (topicFrames topics) (WS.sendTextData c)
        heard <- Heard <$> newTVarIO Map.empty <*> newTVarIO Set.empty <*> newTVarIO False <*> newTVarIO False <*> newTVarIO False
        sendFrames s c `race_` receiveFrames link heard c `race_` renewSilent link heard `race_` steer s heard
    sendFrames s c = do
      frame <- atomically (readTQueue (outgoing link))
      -- What the system does not take yet may expire meanwhile.
      withFdSocket s (threadWaitWrite . Fd)
      heartbeat <- lastHeartbeat (heartbeats link)
      t <- bootSeconds
      case frame of
        Just expiring' -> mapM_ (WS.sendTextData c) (valueAt heartbeat t expiring') >> sendFrames s c
        Nothing -> WS.sendClose c ("" :: Text) >> delayInSlices flushTimeout -- the answer ends the conversation
    steer s heard = do
      known <- namedRoutes link heard
      -- The robot may be driven from here on: its velocity topic is known and a guardian has the socket.
      maybe id (guardingSocket (heartbeats link) s) (stopBytes known) $ do
        atomically $ do
          writeTVar (currentRoutes link) known
          mapM_ (writeFrame link) (advertiseFrames (filter isVelocity known))
          writeTVar (isSteered heard) True
          isHeard <- readTVar (hasOdometry heard)
          when isHeard (becomesPresent link heard)
        forever (threadDelay lastPause)
    ended e = case e of
      WS.CloseRequest _ _ -> tr "the server closed the connection"
      WS.ConnectionClosed -> tr "the connection was closed"
      _ -> tr "the server does not speak WebSocket"

isVelocity :: Route -> Bool
isVelocity r = routeChannel r == velocityChannel

send :: Link -> [L.ByteString] -> IO ()
send link = atomically . mapM_ (writeFrame link)

writeFrame :: Link -> L.ByteString -> STM ()
writeFrame link = writeTQueue (outgoing link) . Just . lasting . Just

-- | What has been heard on one connection.
data Heard = Heard
  { -- | the server's answers about the velocity topic
    velocityTypes :: TVar VelocityTypes,
    -- | topics that have said something since the robot was connected or lost
    spokenTopics :: TVar (Set.Set Text),
    -- | whether odometry has arrived
    hasOdometry :: TVar Bool,
    -- | whether the robot may be driven
    isSteered :: TVar Bool,
    -- | whether the robot is connected
    isPresent :: TVar Bool
  }

-- | The robot is there, and may be driven.
becomesPresent :: Link -> Heard -> STM ()
becomesPresent link heard = writeTVar (isPresent heard) True >> enqueue (hearing link) Connected

receiveFrames :: Link -> Heard -> WS.Connection -> IO ()
receiveFrames link heard c = do
  -- A caller that waits has been told that the server has no odometry.
  missing <- newIORef False
  messageCount <- newTVarIO (0 :: Int)
  complained <- newIORef Nothing
  let known = plainRoutes link
      noOdometry = trWith "the server answers and has no odometry called {topic}; does the base's own program run?" ["topic" =: T.pack (odometryTopic known)]
      read' = forever $ do
        bytes <- WS.receiveData c
        -- A command that is refused is refused ten times a second: the same words are told once.
        taken <- map topicName . filter ((== Taken) . topicUse) <$> readTVarIO (ownTopics link)
        let frame = decodeFrame known taken bytes
        forM_ (frameComplaint frame) $ \what -> do
          before <- readIORef complained
          writeIORef complained (Just what)
          when (before /= Just what) (atomically (enqueue (hearing link) (Complained what)))
        forM_ (frameUnreadable frame) (atomically . enqueueUnreadable (hearing link))
        forM_ (frameType frame) $ \(topic, kind) -> atomically (modifyTVar' (velocityTypes heard) (Map.insert topic kind))
        forM_ (frameTopic frame) $ \topic -> do
          atomically (modifyTVar' (spokenTopics heard) (Set.insert topic))
          forM_ (frameStamp frame) $ \stamp ->
            when (topic == T.pack (odometryTopic known)) (getPOSIXTime >>= \now -> atomically (writeTVar (clockOffset link) (stamp - realToFrac now)))
        changed <- atomically $ do
          -- A message without a change is a sign of life too.
          modifyTVar' messageCount (+ length (frameMessages frame))
          stateTVar (levels link) (onlyChanges known (frameMessages frame))
        forM_ changed $ \m -> atomically $ do
          case m of
            OdometryMessage _ -> do
              writeTVar (hasOdometry heard) True
              mayDrive <- readTVar (isSteered heard)
              wasPresent <- readTVar (isPresent heard)
              when (mayDrive && not wasPresent) (becomesPresent link heard)
            _ -> pure ()
          enqueue (hearing link) (Received m)
      -- Only a connected robot can be lost.
      watch = do
        before <- readTVarIO messageCount
        came <- timeoutInSlices silenceTimeout (atomically (readTVar messageCount >>= check . (/= before)))
        wasPresent <- readTVarIO (isPresent heard)
        lately <- readIORef missing
        if isNothing came && wasPresent
          then atomically $ do
            writeTVar (isPresent heard) False
            writeTVar (spokenTopics heard) Set.empty
            enqueue (hearing link) (Disconnected (tr "nothing was heard of it for a second"))
          else when (isNothing came && not lately) (atomically (enqueue (hearing link) (Disconnected noOdometry)))
        writeIORef missing (isNothing came)
        watch
  void (race read' watch)

-- | The routes with the topic and the type of velocities that the server names: asked at once, and while no node has such a topic again
-- when the robot's odometry arrives. Those of the robot's description when it is not to be asked or does not know.
namedRoutes :: Link -> Heard -> IO [Route]
namedRoutes link heard = case filter isVelocity (plainRoutes link) of
  r : _ | asksVelocityType link -> asking r askAgain
  _ -> pure (plainRoutes link)
  where
    asking r left = do
      let questions = velocityQuestions r
      atomically (writeTVar (velocityTypes heard) Map.empty)
      send link (map snd questions)
      _ <- timeoutInSlices answerTimeout (atomically (readTVar (velocityTypes heard) >>= check . (== length questions) . Map.size))
      types <- readTVarIO (velocityTypes heard)
      wasThere <- readTVarIO (hasOdometry heard)
      case velocityRoute types r of
        Left kind -> do
          atomically (enqueue (hearing link) (Misunderstood (strangeVelocity (routeTopic r) kind)))
          pure (plainRoutes link)
        Right (Just named) -> pure [if isVelocity x then named else x | x <- plainRoutes link]
        Right Nothing
          | all isNothing types || left == 0 -> pure (plainRoutes link)
          | wasThere -> threadDelay askPause >> asking r (left - 1)
          | otherwise -> atomically (readTVar (hasOdometry heard) >>= check) >> asking r left

-- | How often a server is asked again for the type of velocities of a robot whose odometry arrives, and after what time, microseconds: on ROS 2 the parts of
-- a robot are not discovered at the same moment.
askAgain, askPause :: Int
askAgain = 5
askPause = 200000

-- | Time for a server to answer, microseconds. One without rosapi never does.
answerTimeout :: Int
answerTimeout = 1000000

-- | Subscribes again to topics that should say something all the time and are silent, and, when a robot has come later, once to all that have not said
-- anything. An event may pass while its topic is subscribed again, so those topics are left alone otherwise.
renewSilent :: Link -> Heard -> IO ()
renewSilent link heard = go 0 False
  where
    go rounds wasThere = do
      _ <- timeoutInSlices (renewalPause rounds) (atomically (readTVar (isPresent heard) >>= check . (/= wasThere)))
      isThere <- readTVarIO (isPresent heard)
      spoken <- readTVarIO (spokenTopics heard)
      let hasCome = isThere && not wasThere && rounds > 0
          silent = [r | r <- map NonEmpty.head (filter (\rs -> hasCome || any speaks rs) (sensorTopics (plainRoutes link))), Set.notMember (routeTopic r) spoken]
      when (isThere == wasThere || hasCome) $ do
        send link (concatMap renewalFrames silent)
        own <- readTVarIO (ownTopics link)
        when hasCome (send link (concat [ownRenewalFrames t | t <- own, Set.notMember (T.pack (topicName t)) spoken]))
      go (if isThere == wasThere then rounds + 1 else 0) isThere
    speaks r = routeHasLevels r || channelKind (routeChannel r) `elem` [StateChannel, ClockChannel]

-- | Pause before a topic is subscribed again, microseconds: a second the first five times, then longer, up to eight.
renewalPause :: Int -> Int
renewalPause rounds = 1000000 * (if rounds < 5 then 1 else min 8 (2 ^ (rounds - 4)))

-- | Pauses between attempts, microseconds.
firstPause, lastPause :: Int
firstPause = 100000
lastPause = 1600000
