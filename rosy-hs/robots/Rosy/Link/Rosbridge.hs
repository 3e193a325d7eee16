{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Link.Rosbridge
-- Description : A robot behind a rosbridge server.
--
-- In: the address of the server and the names of the base's topics. Out: a 'Connection' while an action runs. A thread
-- connects, and again whenever the connection is lost; the robot is connected when its odometry arrives, and lost
-- when nothing has arrived for a second.
module Rosy.Link.Rosbridge
  ( withRosbridge,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (race, race_, withAsync)
import Control.Concurrent.STM
import Control.Exception (Handler (..), IOException, bracket, catches, finally)
import Control.Monad (forM_, forever, void, when)
import qualified Data.ByteString.Lazy as L
import Data.IORef
import Data.Maybe (isNothing)
import Data.Text (Text)
import qualified Data.Text as T
import Network.Socket (close)
import qualified Network.WebSockets as WS
import Ros.Net.Rpc (connectTo)
import Ros.SlicedTimeout (delayInSlices, timeoutInSlices)
import Rosy.Codec (Levels, Route, noLevels, nothingHeld, onlyChanges)
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Robot (pattern OdometryMessage)
import Rosy.Robots.Connection
import Rosy.Robots.ConnectionError (explainConnectionError)
import Rosy.Robots.RosbridgeCodec
import Rosy.Robots.Target
import Rosy.Sentence

withRosbridge :: String -> Int -> String -> [Route] -> (Connection -> IO a) -> IO a
withRosbridge host port path known use = do
  hearing <- newEventQueue
  outgoing <- newTQueueIO
  connected <- newTVarIO False
  own <- newTVarIO []
  held <- newTVarIO nothingHeld
  levels <- newTVarIO noLevels
  let connection =
        Connection
          { connectionName = trWith "the robot at {address}" ["address" =: T.pack ("ws://" ++ host ++ ":" ++ show port ++ path)],
            connectionRoutes = known,
            registerTopics = \topics -> do
              atomically $ do
                before <- readTVar own
                let new = filter (`notElem` before) topics
                writeTVar own (before ++ new)
                isConnected <- readTVar connected
                when isConnected (mapM_ (writeTQueue outgoing . Just) (topicFrames new))
              pure [],
            sendCommand = \a -> atomically $ do
              frame <- stateTVar held (encodeCommand known a)
              isConnected <- readTVar connected
              when isConnected (mapM_ (writeTQueue outgoing . Just) frame),
            takeEvents = awaitEvents hearing
          }
      -- What was told last, a stop, is to arrive: the base would notice the silence only 0.6 s later. The server answers a goodbye
      -- behind it; a connection that is closed with odometry unread takes along what is still under way.
      goodbye = do
        atomically (readTVar connected >>= \c -> when c (writeTQueue outgoing Nothing))
        timeoutInSlices flushTimeout (atomically (readTVar connected >>= check . not))
  withAsync (keepConnected host port path known own levels hearing outgoing connected) $ \_ -> use connection `finally` goodbye

-- | Half a second, in microseconds.
flushTimeout :: Int
flushTimeout = 500000

-- | Time without a message after which the robot counts as lost, microseconds: fifty odometry messages are missing.
silenceTimeout :: Int
silenceTimeout = 1000000

keepConnected :: String -> Int -> String -> [Route] -> TVar [Topic] -> TVar Levels -> EventQueue -> TQueue (Maybe L.ByteString) -> TVar Bool -> IO ()
keepConnected host port path known own levels hearing outgoing connected = go firstPause unknownReason
  where
    go pause said = do
      why <- (runConnection >> pure (tr "the connection ended")) `catches` [Handler (\e -> pure (explainConnectionError (e :: IOException))), Handler (\e -> pure (ended (e :: WS.ConnectionException))), Handler (\(_ :: WS.HandshakeException) -> pure (tr "what listens there is no rosbridge server"))]
      wasConnected <- atomically (swapTVar connected False <* flushTQueue outgoing)
      if wasConnected || why /= said then atomically (enqueue hearing (Disconnected why)) else pure ()
      threadDelay pause
      go (if wasConnected then firstPause else min lastPause (pause * 2)) why
    runConnection = bracket (connectTo host port) close $ \s ->
      WS.runClientWithSocket s (host ++ ":" ++ show port) path WS.defaultConnectionOptions [] $ \c -> do
        forM_ (openingFrames known) (WS.sendTextData c)
        topics <- atomically (writeTVar connected True >> readTVar own)
        forM_ (topicFrames topics) (WS.sendTextData c)
        race_ (sendFrames c) (receiveFrames c)
    sendFrames c =
      atomically (readTQueue outgoing) >>= \case
        Just frame -> WS.sendTextData c frame >> sendFrames c
        Nothing -> WS.sendClose c ("" :: Text) >> delayInSlices flushTimeout -- the answer ends the conversation
    receiveFrames c = do
      present <- newIORef False
      -- A caller that waits has been told that the server has no odometry.
      missing <- newIORef False
      messageCount <- newTVarIO (0 :: Int)
      complained <- newIORef Nothing
      let read' = forever $ do
            frame <- WS.receiveData c
            -- A command that is refused is refused ten times a second: the same words are told once.
            forM_ (complaintOf frame) $ \what -> do
              before <- readIORef complained
              writeIORef complained (Just what)
              when (before /= Just what) (atomically (enqueue hearing (Complained what)))
            taken <- map topicName . filter ((== Taken) . topicUse) <$> readTVarIO own
            let messages = decodeFrame known taken frame
            changed <- atomically $ do
              -- A message without a change is a sign of life too.
              modifyTVar' messageCount (+ length messages)
              stateTVar levels (onlyChanges known messages)
            forM_ changed $ \m -> do
              wasPresent <- readIORef present
              atomically $ do
                case m of
                  OdometryMessage _ | not wasPresent -> enqueue hearing Connected
                  _ -> pure ()
                enqueue hearing (Received m)
              case m of
                OdometryMessage _ -> writeIORef present True
                _ -> pure ()
          -- Only a connected robot can be lost.
          watch = do
            before <- readTVarIO messageCount
            came <- timeoutInSlices silenceTimeout (atomically (readTVar messageCount >>= check . (/= before)))
            wasPresent <- readIORef present
            lately <- readIORef missing
            if isNothing came && wasPresent
              then do
                writeIORef present False
                atomically (enqueue hearing (Disconnected (tr "nothing was heard of it for a second")))
              else when (isNothing came && not lately) (atomically (enqueue hearing (Disconnected noOdometry)))
            writeIORef missing (isNothing came)
            watch
      void (race read' watch)
    noOdometry = trWith "the server answers and has no odometry called {topic}; does the base's own program run?" ["topic" =: T.pack (odometryTopic known)]
    ended e = case e of
      WS.CloseRequest _ _ -> tr "the server closed the connection"
      WS.ConnectionClosed -> tr "the connection was closed"
      _ -> tr "the server does not speak WebSocket"

-- | Pauses between attempts, microseconds.
firstPause, lastPause :: Int
firstPause = 100000
lastPause = 1600000
