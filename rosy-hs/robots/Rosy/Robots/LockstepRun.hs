{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Robots.LockstepRun
-- Description : Run of a sandboxed program on a real robot, in lockstep.
--
-- In: a socket to a program that expects the simulator, and a connection to a robot. Out: how the run ended. The program runs
-- in its sandbox and uses the protocol of the simulator: it gets steps of 20 ms with
-- the real time, and its commands pass the guard. A run whose program does not answer a step in time is ended; the base has stopped
-- by itself before.
module Rosy.Robots.LockstepRun
  ( runLockstep,
    Pace (..),
    realPace,
    defaultStepTimeout,
    Observer (..),
    SettledStep (..),
    onTerminal,
    LockstepResult (..),
    RunEnd (..),
  )
where

import Control.Concurrent (threadWaitRead)
import Control.Concurrent.STM
import Control.Exception (IOException, try)
import Control.Monad (forM_, unless, when, (>=>))
import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.IORef
import Data.Maybe (isJust, isNothing)
import qualified Data.Text as T
import Network.Socket (Socket, withFdSocket)
import Network.Socket.ByteString (recv)
import Network.Socket.ByteString.Lazy (sendAll)
import Ros.SlicedTimeout (timeoutInSlices)
import Rosy.Channel (Action, Message)
import Rosy.Codec (routeTopic)
import Rosy.Core (Topic, topicName)
import Rosy.Robot
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.LinkRecorder (LineSource (..))
import Rosy.Robots.LockstepState
import Rosy.Robots.PipeCodec
import Rosy.Sentence
import Rosy.Wire (pipeRoutes)
import System.Posix.Types (Fd (..))

-- | Runs until the program ends, is stopped, or has run for so many seconds of the robot. The second number is how many seconds a lost robot is
-- waited for. A run of limited time also waits so long for its robot, or as long as the run if that is longer.
runLockstep :: Pace -> Observer -> STM Bool -> Maybe Double -> Double -> TVar Guard -> Connection -> Socket -> IO LockstepResult
runLockstep pace observer stopWanted seconds patience guarded connection socket =
  newLockstep pace observer stopWanted seconds patience guarded connection socket >>= runProgram

-- | From the start of the program to its end.
runProgram :: Lockstep -> IO LockstepResult
runProgram run@Lockstep {..} = do
  -- A robot that is held already is here.
  there <- isConnected <$> readTVarIO guarded
  early <- if there then pure [] else onNotice observer (IsAwaited unknownReason) >> awaitRobot run []
  readTVarIO guarded >>= writeIORef present . isConnected
  seed <- newSeed pace
  timeOfDay pace >>= say run . startLine seed
  opened <- listen run
  -- Until it was ready the program had not started.
  meanwhile <- atomically (takeEvents connection `orElse` pure []) >>= fmap concat . mapM (passes run)
  maybe (steps run 0 (early ++ withoutEvents meanwhile)) (ended run 0) opened

-- * The program

-- | The next line of the program; an end when it is gone or takes too long.
nextLine :: Lockstep -> IO (Either RunEnd B.ByteString)
nextLine run@Lockstep {..} = do
  bytes <- readIORef unread
  case C.elemIndex '\n' bytes of
    Just i -> Right (B.take i bytes) <$ writeIORef unread (B.drop (i + 1) bytes)
    Nothing -> do
      some <- timeoutInSlices (ceiling (stepTimeout pace * 1e6)) (withFdSocket socket (threadWaitRead . Fd))
      case some of
        Nothing -> pure (Left Stuck)
        Just () ->
          try (recv socket 65536) >>= \case
            Left e -> Left Died <$ pure (e :: IOException)
            Right b
              | B.null b -> pure (Left Died)
              | otherwise -> writeIORef unread (bytes <> b) >> nextLine run

-- | Carries out commands of the program until it has settled. The result is how the run ended, if it did.
listen :: Lockstep -> IO (Maybe RunEnd)
listen run@Lockstep {..} = do
  heard' <- nextLine run
  case heard' of
    Left e -> pure (Just e)
    Right bytes ->
      onLines observer FromProgram (L.fromStrict bytes <> "\n") >> case readProgramLine bytes of
        Just (Commands a) -> modifyIORef' commands (a :) >> mapM_ (carry run) (resolveCommand connection a) >> listen run
        Just (DeclaresTopic t) -> modifyIORef' own (++ [t | isOwn t]) >> listen run
        Just Ready -> do
          missing <- readIORef own >>= registerTopics connection
          pure
            ( case missing of
                why : _ -> Just (Failed why (tr "Another way to the robot may have it.") Nothing)
                [] -> Nothing
            )
        Just (Settled report) -> Nothing <$ settles run report
        Just (HasEnded how p report) -> do
          when (isJust (reportObserved report)) (settles run report)
          pure . Just $ case how of
            "error" -> maybe (Failed (tr "The program failed.") (verbatim "") Nothing) (\(m, hint, v) -> Failed m hint (Just v)) p
            "stopped" -> Stopped
            _ -> Finished
        Nothing -> pure (Just (Failed (tr "The program said something that a robot does not understand.") (verbatim "") Nothing))

-- | Reports a step that the program has done.
settles :: Lockstep -> StepReport -> IO ()
settles Lockstep {..} report = do
  done <- readIORef commands <* writeIORef commands []
  unless (null (reportFired report) && isNothing (reportObserved report)) (onSettled observer (SettledStep report (reverse done)))

-- | Whether a topic is not one of the robot.
isOwn :: Topic -> Bool
isOwn t = T.pack (topicName t) `notElem` map routeTopic pipeRoutes

-- | Carries out a command, as far as the guard lets it.
carry :: Lockstep -> Action -> IO ()
carry run@Lockstep {..} a = do
  onProgramCommand observer a
  t <- timeNow pace
  drives <- mayBeDriven <$> readTVarIO guarded
  case callsServer a of
    Just frame | not drives -> refuseCall connection frame mayNotDrive
    _ -> guarding run (onCommand t a) >>= mapM_ (sendCommand connection t)

-- | Sends lines to the program, which may be gone.
say :: Lockstep -> Builder.Builder -> IO ()
say Lockstep {..} builder = do
  let bytes = Builder.toLazyByteString builder
  try (sendAll socket bytes) >>= either (\(_ :: IOException) -> pure ()) pure
  onLines observer ToProgram bytes

-- * The robot

-- | Messages of an event for the program; notices go to the observer.
passes :: Lockstep -> RobotEvent -> IO [Message]
passes run@Lockstep {..} h = do
  t <- timeNow pace
  wasHere <- isConnected <$> readTVarIO guarded
  case h of
    Disconnected why
      | wasHere -> onNotice observer (IsLost why) >> writeIORef lost (Just (t, why))
      | otherwise -> onNotice observer (IsAwaited why)
    Refused why -> onNotice observer (IsRefused why) >> writeIORef refused (Just why)
    Connected -> do
      l <- readIORef lost
      onNotice observer (if null l then IsThere else IsBack)
      writeIORef lost Nothing
    Complained what -> onNotice observer (IsComplaining what)
    Misunderstood what -> onNotice observer (IsUnreadable what)
    Received _ -> pure ()
  (ms, actions) <- guarding run (onEvent h)
  mapM_ (sendCommand connection t) actions
  unless (null ms) (onMessages observer ms)
  forM_ ms $ \case
    OdometryMessage o -> writeIORef pose (Just (odometryPosition o, odometryOrientation o))
    _ -> pure ()
  pure ms

-- | Until the robot is there, or never will be. Takes and gives the messages for the program from before its start.
awaitRobot :: Lockstep -> [Message] -> IO [Message]
awaitRobot run@Lockstep {..} early = do
  hs <- atomically ((Nothing <$ (((||) <$> stopWanted <*> givesUp) >>= check)) `orElse` (Just <$> takeEvents connection))
  case hs of
    Nothing -> pure early
    Just some -> do
      ms <- concat <$> mapM (passes run) some
      there <- isConnected <$> readTVarIO guarded
      never <- readIORef refused
      (if there || isJust never then pure else awaitRobot run) (early ++ withoutEvents ms)

-- * Steps

-- | Steps from this one on. Takes messages that are part of the first of them.
steps :: Lockstep -> Int -> [Message] -> IO LockstepResult
steps run@Lockstep {..} n early = do
  awaitStep pace
  stop <- atomically stopWanted
  l <- readIORef lost
  never <- readIORef refused
  t <- timeNow pace
  when (n == 0) (writeIORef beganAt t)
  since' <- readIORef beganAt
  came <- readIORef present
  let isOver = maybe False (t - since' >=) seconds || not (came || isJust never)
  case l of
    _ | stop || isOver -> ended run n =<< (say run stopLine >> listenToTheEnd run)
    _ | Just why <- never -> say run stopLine >> ended run n (RobotRefused why)
    Just (since, why) | t - since > patience -> say run stopLine >> ended run n (RobotLost why)
    _ -> do
      some <- atomically (takeEvents connection `orElse` pure [])
      arrived <- (early ++) . concat <$> mapM (passes run) some
      (ms, actions) <- guarding run (freshMessages t arrived)
      mapM_ (sendCommand connection t) actions
      since <- readIORef beganAt
      watched <- observes observer
      say run (batchLines (StepQuestions (watched && n `mod` tickSteps == 0) watched) n (t - since) ms)
      outcome <- listen run
      case outcome of
        Just e -> ended run n e
        Nothing -> do
          when (n `mod` tickSteps == 0) $ do
            t' <- timeNow pace
            guarding run (onTick t') >>= mapM_ (sendCommand connection t')
            drives <- mayBeDriven <$> readTVarIO guarded
            unless drives (cancelGoals connection)
            guarding run (noticeMotion t') >>= mapM_ (motionNotice connection >=> onNotice observer)
          steps run (n + 1) []

-- | How the program ends after it was told to stop.
listenToTheEnd :: Lockstep -> IO RunEnd
listenToTheEnd run = listen run >>= maybe (listenToTheEnd run) pure

-- | Halts the wheels. The number is how many steps the program has answered.
ended :: Lockstep -> Int -> RunEnd -> IO LockstepResult
ended run@Lockstep {..} n e = do
  cancelGoals connection
  sendNow connection (stateTVar guarded haltWheels)
  came <- readIORef present
  LockstepResult (if came || e /= Stopped then e else NeverRan) n <$> readIORef pose

guarding :: Lockstep -> (Guard -> (b, Guard)) -> IO b
guarding run f = atomically (stateTVar (guarded run) f)
