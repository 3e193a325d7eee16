{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Link.Rosbridge
-- Description : A robot behind a rosbridge server.
--
-- In: where the server is and what the base's topics are called. Out: a 'Base' while an action runs. A thread
-- connects, and again whenever the connection is lost; the robot is there when its odometry arrives, and lost
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
import Data.IORef
import Data.Maybe (isNothing)
import Data.Text (Text)
import Network.Socket (close)
import qualified Network.WebSockets as WS
import Ros.Net.Rpc (connectTo)
import Rosy.Core (Action, Message (..))
import Rosy.Robots.Base
import Rosy.Robots.Reason (reason)
import Rosy.Robots.Rosbridge
import Rosy.Robots.Target
import System.Timeout (timeout)

withRosbridge :: String -> Int -> String -> Profile -> (Base -> IO a) -> IO a
withRosbridge host port path profile use = do
  hearing <- newHearing
  outgoing <- newTQueueIO
  connected <- newTVarIO False
  let base =
        Base
          { baseName = "the robot at ws://" ++ host ++ ":" ++ show port ++ path,
            tell = \a -> atomically (readTVar connected >>= \c -> if c then writeTQueue outgoing (Just a) else pure ()),
            hear = hearAll hearing
          }
      -- What was told last, a stop, is to arrive: the base would notice the silence only 0.6 s later. The server answers a goodbye
      -- behind it; a connection that is closed with odometry unread takes along what is still under way.
      goodbye = timeout farewell $ do
        atomically (readTVar connected >>= \c -> when c (writeTQueue outgoing Nothing))
        atomically (readTVar connected >>= check . not)
  withAsync (keepConnected host port path profile hearing outgoing connected) $ \_ -> use base `finally` goodbye

-- | Half a second, in microseconds.
farewell :: Int
farewell = 500000

-- | Nothing heard for so long means that the robot is lost, microseconds: fifty odometry messages are missing.
silence :: Int
silence = 1000000

keepConnected :: String -> Int -> String -> Profile -> Hearing -> TQueue (Maybe Action) -> TVar Bool -> IO ()
keepConnected host port path profile hearing outgoing connected = go firstPause ""
  where
    go pause said = do
      why <- (converse >> pure "the connection ended") `catches` [Handler (\e -> pure (reason (e :: IOException))), Handler (\e -> pure (ended (e :: WS.ConnectionException))), Handler (\(_ :: WS.HandshakeException) -> pure "what listens there is no rosbridge server")]
      wasConnected <- atomically (swapTVar connected False <* flushTQueue outgoing)
      if wasConnected || why /= said then atomically (heard hearing (Gone why)) else pure ()
      threadDelay pause
      go (if wasConnected then firstPause else min lastPause (pause * 2)) why
    converse = bracket (connectTo host port) close $ \s ->
      WS.runClientWithSocket s (host ++ ":" ++ show port) path WS.defaultConnectionOptions [] $ \c -> do
        forM_ (greeting profile) (WS.sendTextData c)
        atomically (writeTVar connected True)
        race_ (speak c) (listen c)
    speak c =
      atomically (readTQueue outgoing) >>= \case
        Just a -> WS.sendTextData c (command profile a) >> speak c
        Nothing -> WS.sendClose c ("" :: Text) >> threadDelay farewell -- the answer ends the conversation
    listen c = do
      present <- newIORef False
      -- Somebody who waits has been told that the server has no odometry.
      missing <- newIORef False
      lastWords <- newTVarIO (0 :: Int)
      let read' = forever $ do
            frame <- WS.receiveData c
            forM_ (understand profile frame) $ \m -> do
              known <- readIORef present
              atomically $ do
                modifyTVar' lastWords (+ 1)
                case m of
                  OdometryMessage _ | not known -> heard hearing Here
                  _ -> pure ()
                heard hearing (Heard m)
              case m of
                OdometryMessage _ -> writeIORef present True
                _ -> pure ()
          -- Only a robot that was there can fall silent.
          watch = do
            before <- readTVarIO lastWords
            came <- patiently silence (atomically (readTVar lastWords >>= check . (/= before)))
            known <- readIORef present
            lately <- readIORef missing
            if isNothing came && known
              then do
                writeIORef present False
                atomically (heard hearing (Gone "nothing was heard of it for a second"))
              else when (isNothing came && not lately) (atomically (heard hearing (Gone (noOdometry profile))))
            writeIORef missing (isNothing came)
            watch
      void (race read' watch)
    noOdometry p = "the server answers and has no odometry called " ++ odometryTopic p ++ "; does the base's own program run?"
    ended e = case e of
      WS.CloseRequest _ _ -> "the server closed the connection"
      WS.ConnectionClosed -> "the connection was closed"
      _ -> "the server does not speak WebSocket"

-- | Pauses between attempts, microseconds.
firstPause, lastPause :: Int
firstPause = 100000
lastPause = 1600000
