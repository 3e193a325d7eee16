{-# LANGUAGE OverloadedStrings #-}

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

import Control.Concurrent (threadDelay, threadWaitRead)
import Control.Concurrent.STM
import Control.Exception (IOException, try)
import Control.Monad (forM_, unless, when, (>=>))
import Data.Aeson (Value)
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
import Rosy.Core (topicName)
import Rosy.Robot
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.LinkRecorder (LineSource (..))
import Rosy.Robots.PipeCodec
import Rosy.Robots.Wording (tellPerson)
import Rosy.Sentence
import Rosy.Wire (pipeRoutes)
import System.Posix.Types (Fd (..))
import System.Random (randomRIO)

-- | Callbacks of a run; none of them may block.
data Observer = Observer
  { -- | messages for the program, in its own frame
    onMessages :: [Message] -> IO (),
    -- | a command of the program, before the guard
    onProgramCommand :: Action -> IO (),
    -- | a step in which functions fired, or that is observed
    onSettled :: SettledStep -> IO (),
    -- | whether the program is to tell its firings with their provenance, from the next step on
    observes :: IO Bool,
    -- | the robot is awaited, lost or back
    onNotice :: Notice -> IO (),
    -- | lines of the robot link, each with its newline
    onLines :: LineSource -> L.ByteString -> IO ()
  }

-- | A step that the program has done: what it tells of it, and its commands in their order.
data SettledStep = SettledStep StepReport [Action]

-- | For a terminal: texts of the program go to standard output, the state of the connection to standard error.
onTerminal :: Sentence -> Observer
onTerminal name =
  Observer
    { onMessages = const (pure ()),
      onProgramCommand = \case
        SayCommand (Say s) -> putStrLn s
        _ -> pure (),
      onSettled = const (pure ()),
      observes = pure False,
      onNotice = tellPerson . explainNotice name,
      onLines = \_ _ -> pure ()
    }

data LockstepResult = LockstepResult
  { runEnd :: RunEnd,
    -- | steps that the program has answered
    stepsRun :: Int,
    -- | where the robot was last, from where it started
    lastPose :: Maybe (Position, Orientation)
  }

data RunEnd
  = Finished
  | Stopped
  | -- | message and hint; the problem as the program reported it
    Failed Sentence Sentence (Maybe Value)
  | -- | it did not answer
    Stuck
  | -- | the program ended without a message
    Died
  | -- | the robot is gone, for this reason
    RobotLost Sentence
  | -- | the robot can never be driven, for this reason
    RobotRefused Sentence
  | -- | it was stopped, or its time was over, before the robot was there
    NeverRan
  deriving (Eq, Show)

-- | Sources of randomness and time of a run.
data Pace = Pace
  { -- | the random seed of this run
    newSeed :: IO Int,
    -- | seconds of a clock that runs while the computer sleeps
    timeNow :: IO Double,
    -- | the time of day, seconds
    timeOfDay :: IO Double,
    -- | waits until the next step begins
    awaitStep :: IO (),
    -- | longest time in which the program may answer a step, seconds; pauses of this computer do not count
    stepTimeout :: Double
  }

-- | Fifty steps a second from now on, with this step timeout. One that came late is not caught up with.
realPace :: Double -> IO Pace
realPace timeout = do
  due <- bootSeconds >>= newIORef
  pure
    Pace
      { newSeed = randomRIO (0, 2 ^ (31 :: Int) - 1),
        timeNow = bootSeconds,
        timeOfDay = secondsOfDay,
        awaitStep = do
          t <- bootSeconds
          -- After a pause, as before the first step, the next one is a whole step away.
          begins <- (\d -> if t - d > stepLength then t else d) <$> readIORef due
          when (begins > t) (threadDelay (ceiling ((begins - t) * 1e6)))
          writeIORef due (begins + stepLength),
        stepTimeout = timeout
      }

-- | The step timeout of the simulator, seconds (@settle@ in @sim-service/rosy_sim/config.py@): programs have a low priority, and on a
-- busy computer one may get no processor for two seconds. The base stops by itself after 0.6 s.
defaultStepTimeout :: Double
defaultStepTimeout = 5

-- | A step, seconds (protocol/README.md).
stepLength :: Double
stepLength = 0.02

-- | Steps from one tick of the default rate to the next (protocol/README.md).
tickSteps :: Int
tickSteps = 5

-- | Runs until the program ends, is stopped, or has run for so many seconds of the robot. The second number is how many seconds a lost robot is
-- waited for. A run of limited time also waits so long for its robot, or as long as the run if that is longer.
runLockstep :: Pace -> Observer -> STM Bool -> Maybe Double -> Double -> TVar Guard -> Connection -> Socket -> IO LockstepResult
runLockstep pace observer stopWanted seconds patience guarded connection socket = do
  givesUp <- maybe (pure (pure False)) (\s -> readTVar <$> registerDelay (ceiling (max s patience * 1e6))) seconds
  present <- newIORef False
  unread <- newIORef B.empty
  own <- newIORef []
  pose <- newIORef Nothing
  lost <- newIORef Nothing
  refused <- newIORef Nothing
  beganAt <- newIORef 0
  -- Commands of this step, newest first.
  commands <- newIORef []
  let guarding :: (Guard -> (b, Guard)) -> IO b
      guarding f = atomically (stateTVar guarded f)
      now = timeNow pace
      -- The next line of the program; nothing when it is gone or takes too long.
      line = do
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
                    | otherwise -> writeIORef unread (bytes <> b) >> line
      -- Carries out commands of the program until it has settled.
      listen = do
        heard' <- line
        case heard' of
          Left e -> pure (Just e)
          Right bytes ->
            onLines observer FromProgram (L.fromStrict bytes <> "\n") >> case readProgramLine bytes of
              Just (Commands a) -> modifyIORef' commands (a :) >> mapM_ carry (resolveCommand connection a) >> listen
              Just (DeclaresTopic t) -> modifyIORef' own (++ [t | isOwn t]) >> listen
              Just Ready -> do
                missing <- readIORef own >>= registerTopics connection
                pure
                  ( case missing of
                      why : _ -> Just (Failed why (tr "Another way to the robot may have it.") Nothing)
                      [] -> Nothing
                  )
              Just (Settled report) -> Nothing <$ settles report
              Just (HasEnded how p report) -> do
                when (isJust (reportObserved report)) (settles report)
                pure . Just $ case how of
                  "error" -> maybe (Failed (tr "The program failed.") (verbatim "") Nothing) (\(m, hint, v) -> Failed m hint (Just v)) p
                  "stopped" -> Stopped
                  _ -> Finished
              Nothing -> pure (Just (Failed (tr "The program said something that a robot does not understand.") (verbatim "") Nothing))
      settles report = do
        done <- readIORef commands <* writeIORef commands []
        unless (null (reportFired report) && isNothing (reportObserved report)) (onSettled observer (SettledStep report (reverse done)))
      isOwn t = T.pack (topicName t) `notElem` map routeTopic pipeRoutes
      carry a = do
        onProgramCommand observer a
        t <- now
        guarding (onCommand t a) >>= mapM_ (sendCommand connection)
      say builder = do
        let bytes = Builder.toLazyByteString builder
        try (sendAll socket bytes) >>= either (\(_ :: IOException) -> pure ()) pure
        onLines observer ToProgram bytes
      -- Messages of an event for the program; notices go to the observer.
      passes h = do
        wasHere <- isConnected <$> readTVarIO guarded
        case h of
          Disconnected why
            | wasHere -> onNotice observer (IsLost why) >> now >>= \t -> writeIORef lost (Just (t, why))
            | otherwise -> onNotice observer (IsAwaited why)
          Refused why -> onNotice observer (IsRefused why) >> writeIORef refused (Just why)
          Connected -> do
            l <- readIORef lost
            onNotice observer (if null l then IsThere else IsBack)
            writeIORef lost Nothing
          Complained what -> onNotice observer (IsComplaining what)
          Misunderstood what -> onNotice observer (IsUnreadable what)
          Received _ -> pure ()
        (ms, actions) <- guarding (onEvent h)
        mapM_ (sendCommand connection) actions
        unless (null ms) (onMessages observer ms)
        forM_ ms $ \case
          OdometryMessage o -> writeIORef pose (Just (odometryPosition o, odometryOrientation o))
          _ -> pure ()
        pure ms
      untilHere early = do
        hs <- atomically ((Nothing <$ (((||) <$> stopWanted <*> givesUp) >>= check)) `orElse` (Just <$> takeEvents connection))
        case hs of
          Nothing -> pure early
          Just some -> do
            ms <- concat <$> mapM passes some
            there <- isConnected <$> readTVarIO guarded
            never <- readIORef refused
            (if there || isJust never then pure else untilHere) (early ++ withoutEvents ms)
      steps n early = do
        awaitStep pace
        stop <- atomically stopWanted
        l <- readIORef lost
        never <- readIORef refused
        t <- now
        when (n == 0) (writeIORef beganAt t)
        since' <- readIORef beganAt
        came <- readIORef present
        let isOver = maybe False (t - since' >=) seconds || not (came || isJust never)
        case l of
          _ | stop || isOver -> ended n =<< (say stopLine >> listenToTheEnd)
          _ | Just why <- never -> say stopLine >> ended n (RobotRefused why)
          Just (since, why) | t - since > patience -> say stopLine >> ended n (RobotLost why)
          _ -> do
            some <- atomically (takeEvents connection `orElse` pure [])
            ms <- (early ++) . concat <$> mapM passes some
            since <- readIORef beganAt
            watched <- observes observer
            say (batchLines (StepQuestions (watched && n `mod` tickSteps == 0) watched) n (t - since) ms)
            outcome <- listen
            case outcome of
              Just e -> ended n e
              Nothing -> do
                when (n `mod` tickSteps == 0) $ do
                  t' <- now
                  guarding (onTick t') >>= mapM_ (sendCommand connection)
                  guarding (noticeMotion t') >>= mapM_ (motionNotice connection >=> onNotice observer)
                steps (n + 1) []
      listenToTheEnd = listen >>= maybe listenToTheEnd pure
      ended n e = do
        guarding haltWheels >>= mapM_ (sendCommand connection)
        came <- readIORef present
        LockstepResult (if came || e /= Stopped then e else NeverRan) n <$> readIORef pose
  -- A robot that is held already is here.
  there <- isConnected <$> readTVarIO guarded
  early <- if there then pure [] else onNotice observer (IsAwaited unknownReason) >> untilHere []
  readTVarIO guarded >>= writeIORef present . isConnected
  seed <- newSeed pace
  timeOfDay pace >>= say . startLine seed
  opened <- listen
  -- Until it was ready the program had not started.
  meanwhile <- atomically (takeEvents connection `orElse` pure []) >>= fmap concat . mapM passes
  maybe (steps 0 (early ++ withoutEvents meanwhile)) (ended 0) opened
