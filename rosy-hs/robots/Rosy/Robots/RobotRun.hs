{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.RobotRun
-- Description : One run of a program's main on a real robot.
--
-- In: which robot, and the program. Out: an exit status; messages for a person go to standard error. The robot
-- is stopped first in every case: when the program is done, fails or is stopped, on Ctrl-C and on a
-- signal of the system. A program that does not react is ended a second after that; once it has reacted, the goodbye to the
-- robot has limits of its own ("Rosy.Robots.Connection").
module Rosy.Robots.RobotRun
  ( runOnRobot,
    runOnRobotFor,
    withConnection,
    sayUnreadable,
    onSignals,
    terminationSignals,
  )
where

import Control.Concurrent (forkIO, myThreadId, threadDelay)
import Control.Concurrent.STM
import Control.Exception
import Control.Monad (forM_, unless, void, when)
import Data.IORef
import Data.Maybe (isNothing)
import qualified Data.Text as T
import Ros.Names (readArguments)
import Ros.Node (Settings (..))
import Ros.SlicedTimeout (timeoutInSlices)
import Rosy.Launch (onLink)
import Rosy.Link
import Rosy.Link.Real
import Rosy.Link.Ros
import Rosy.Link.Rosbridge
import Rosy.Link.Serial
import Rosy.Problem
import Rosy.Robots.ActionClient
import Rosy.Robots.ArmPrompt (startArmPrompt)
import Rosy.Robots.Connection
import Rosy.Robots.DriverLock (withDriverLock)
import Rosy.Robots.Guard (isConnected)
import Rosy.Robots.Target
import Rosy.Robots.UnreadableMessages (unreadableSentences)
import Rosy.Robots.Wording (tellPerson)
import Rosy.Sentence
import System.Environment (getEnvironment)
import System.Exit
import System.IO (BufferMode (..), hSetBuffering, stderr, stdout)
import System.Posix.Process (exitImmediately)
import System.Posix.Signals (Handler (..), Signal, installHandler, sigHUP, sigINT, sigQUIT, sigTERM, sigUSR1)

-- | Connects to the robot of an address while an action runs.
withConnection :: Target -> (Connection -> IO a) -> IO a
withConnection target use = connected target (withActions carrier (profileVariables (targetProfile target)) use)
  where
    carrier = case targetTransport target of
      Serial _ -> NoCarrier
      Ros1 _ _ -> TopicsOfActionlib False
      _ | isRos2 (targetProfile target) -> FramesOfRos2
      _ -> TopicsOfActionlib True

connected :: Target -> (Connection -> IO a) -> IO a
connected target use = case targetTransport target of
  Rosbridge host port path -> withRosbridge host port path (isNothing (targetStamped target)) (targetRoutes target) use
  Serial device -> withSerial device use
  -- A bridge on this computer speaks rosbridge's protocol. For people the robot is at the address that they gave.
  Ros2 domain namespace (Just port) -> withRosbridge "127.0.0.1" port "/" (isNothing (targetStamped target)) (targetRoutes target) (\c -> use c {connectionName = trWith "the robot at {address}" ["address" =: T.pack ("ros2:" ++ domain ++ namespace)]})
  Ros2 _ _ Nothing -> ioError (userError (portable (tr "a robot at ros2: is driven by ./rosy run and ./rosy start; a program of ./rosy build reaches it through rosbridge: ws://HOST:9090")))
  Ros1 host port -> do
    environment' <- getEnvironment
    let at = "http://" ++ host ++ ":" ++ show port
        settings = Settings (readArguments []) (("ROS_MASTER_URI", at) : filter ((/= "ROS_MASTER_URI") . fst) environment') "rosy"
    withRos settings (trWith "the robot at {address}" ["address" =: T.pack ("ros://" ++ host ++ ":" ++ show port)]) (isNothing (targetStamped target)) (targetRoutes target) use

-- | Runs a program's @main@ on a robot.
runOnRobot :: Target -> IO () -> IO ExitCode
runOnRobot = runOnRobotFor Nothing

-- | 'runOnRobot', for so many seconds of the robot at most. A run of limited time waits as long for its robot, or its patience if that is longer.
runOnRobotFor :: Maybe Double -> Target -> IO () -> IO ExitCode
runOnRobotFor seconds target program = withDriverLock (targetAddress target) $ do
  mapM_ (`hSetBuffering` LineBuffering) [stdout, stderr]
  ended <- newIORef EndedDone
  r <- newRunControl (targetGuard target)
  main' <- myThreadId
  reacted <- newTVarIO False
  begun <- newTVarIO False
  absent <- newTVarIO False
  result <- try . withClock $ \clock -> withConnection target $ \connection -> do
    let stopping = do
          haltRobot r connection
          requestStop r
          void . forkIO $ do
            unlessReacted (throwTo main' UserInterrupt)
            -- Code that allocates nothing cannot be interrupted.
            unlessReacted (exitImmediately (ExitFailure 2))
        unlessReacted act = timeoutInSlices stopTimeout (atomically (readTVar reacted >>= check)) >>= maybe act pure
    forM_ seconds $ \s -> runAfter (max s (targetPatience target)) (readTVarIO begun >>= (`unless` stopping))
    startArmPrompt (connectionName connection) (runGuard r)
    link <- realLink clock (targetPatience target) r connection
    let begin topics = do
          opening <- open link topics
          isThere <- isConnected <$> readTVarIO (runGuard r)
          atomically (writeTVar begun isThere >> writeTVar absent (not isThere))
          when isThere (mapM_ (`runAfter` stopping) seconds)
          pure opening
    onSignals terminationSignals stopping (onLink link {open = begin, end = \as e -> writeIORef ended e >> end link as e} program)
      `finally` (atomically (writeTVar reacted True) >> haltRobot r connection >> sayUnreadable connection)
  how <- readIORef ended
  explained <- wasRefused r
  neverCame <- readTVarIO absent
  case result of
    Left e -> ExitFailure 2 <$ unless explained (told (problemFrom Nothing [] Nothing e))
    Right () | neverCame -> ExitFailure 2 <$ unless explained (tellPerson neverRan)
    Right () -> case how of
      EndedError p -> ExitFailure 2 <$ told p
      _ -> pure ExitSuccess
  where
    told p = do
      tellPerson (problemMessage p)
      unless (T.null (english (problemHint p))) (tellPerson (problemHint p))

-- | Says how many messages of the robot could not be read, if there were any.
sayUnreadable :: Connection -> IO ()
sayUnreadable connection = atomically (unreadableMessages connection) >>= mapM_ tellPerson . unreadableSentences

-- | A second, in microseconds: what a program that was asked to stop may still take (protocol/README.md, stop).
stopTimeout :: Int
stopTimeout = 1000000

-- | Runs an action after a number of seconds, in a thread of its own. A thread's delay is counted in an Int of microseconds: a week fits.
runAfter :: Double -> IO () -> IO ()
runAfter seconds = void . forkIO . (threadDelay (ceiling (seconds * 1e6)) >>)

-- | The signals that mean that a program is to end. The last is the emergency stop of @./rosy estop@.
terminationSignals :: [Signal]
terminationSignals = [sigINT, sigTERM, sigHUP, sigQUIT, sigUSR1]

-- | The first of these signals stops in good order. The handlers are put back afterwards.
onSignals :: [Signal] -> IO () -> IO a -> IO a
onSignals signals act body = bracket (mapM install signals) (mapM_ restore) (const body)
  where
    install s = (,) s <$> installHandler s (CatchOnce act) Nothing
    restore (s, old) = installHandler s old Nothing
