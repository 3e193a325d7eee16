{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.RobotProcess
-- Description : Process for one real robot and one owner, which runs one program after another.
--
-- In: a robot, requests of @protocol/README.md@ section 7 from the service, and programs' sockets. Out: lines
-- about the robot's state. The robot is connected and reported before the first program, between programs and after the last. Its
-- wheels turn only while a program runs, the owner's page is visible, no emergency stop is active, and the robot was not lost since the owner
-- let it drive.
module Rosy.Robots.RobotProcess
  ( runRobotProcess,
    ProcessLimits (..),
    defaultLimits,
    Requests,
    newRequests,
    Request (..),
    request,
    readRequest,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (race_)
import Control.Concurrent.STM
import Control.Exception (bracket, finally)
import Control.Monad (forM_, forever, unless, when)
import Data.Aeson (Value (..), (.:))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (parseMaybe)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as L
import Data.Foldable (traverse_)
import Data.Maybe (isJust, isNothing)
import Data.Text (Text)
import qualified Data.Text as T
import Network.Socket (Socket, close)
import Rosy.Robot
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.LinkRecorder
import Rosy.Robots.LockstepRun
import Rosy.Robots.PipeCodec (StepReport (..))
import Rosy.Robots.Target (Profile (..), Target (..), targetGuard)
import Rosy.Robots.Telemetry
import Rosy.Robots.UnreadableMessages (unreadableSentences)
import Rosy.Sentence

data Request
  = -- | a program waits at the next socket
    Run
  | -- | the next program's run is to be recorded in this file
    Record FilePath
  | Stop
  | EmergencyStop
  | -- | the emergency stop is over, and a robot that was lost may drive again
    Free
  | -- | heartbeat: the owner's page was visible at this time, seconds of 'bootSeconds'
    Alive Double
  | -- | the safety rules are to be on, or off
    Safety Bool
  | -- | the firings of programs are to be told with their provenance, or not
    Observe Bool
  | -- | the robot has no owner any more
    Leave
  deriving (Eq, Show)

-- | Nothing for a line that protocol/README.md does not have.
readRequest :: ByteString -> Maybe Request
readRequest bytes = case Aeson.decodeStrict' bytes of
  Just (Object o) -> case parseMaybe (.: "op") o of
    Just "safety" -> Safety <$> parseMaybe (.: "on") o
    Just "observe" -> Observe <$> parseMaybe (.: "on") o
    Just "alive" -> Alive <$> parseMaybe (.: "time") o
    Just "record" -> Record <$> parseMaybe (.: "file") o
    op -> op >>= (`lookup` ops)
  _ -> Nothing
  where
    ops = [("run" :: Text, Run), ("stop", Stop), ("estop", EmergencyStop), ("free", Free)]

-- | Queue of requests that are not handled yet.
newtype Requests = Requests (TQueue Request)

newRequests :: IO Requests
newRequests = Requests <$> newTQueueIO

request :: Requests -> Request -> IO ()
request (Requests queue) = atomically . writeTQueue queue

data RobotProcess = RobotProcess
  { guarded :: TVar Guard,
    robotState :: TVar RobotState,
    -- | start of the process, then of each run; seconds of 'bootSeconds'
    began :: TVar Double,
    -- | start of the active emergency stop, seconds of 'bootSeconds'
    stoppedAt :: TVar (Maybe Double),
    -- | whether the service was told that the wheels are held
    toldHeld :: TVar Bool,
    -- | time of the latest heartbeat, seconds of 'bootSeconds'
    aliveAt :: TVar Double,
    -- | checks of the owner since the latest heartbeat
    silentChecks :: TVar Int,
    -- | whether programs tell their firings
    observed :: TVar Bool,
    -- | file for the next program's run
    recordingFile :: TVar (Maybe FilePath),
    -- | whether a program runs
    isRunning :: TVar Bool,
    -- | how many runs were requested, and up to which of them runs were stopped: a request to stop may come before the run has begun
    requestedRuns :: TVar Int,
    stoppedRuns :: TVar Int,
    lines' :: TBQueue L.ByteString
  }

-- | Lines that wait for a service that does not read; more are dropped.
maxQueuedLines :: Num n => n
maxQueuedLines = 1000

-- | Seconds without a heartbeat after which the wheels stand. With network latency and the check interval of 0.05 s they stand
-- within 0.7 s.
watchTimeout :: Double
watchTimeout = 0.5

-- | Seconds between two checks of the owner.
checkInterval :: Double
checkInterval = 0.05

-- | Limits of a run, seconds.
data ProcessLimits = ProcessLimits
  { -- | for a program to answer a step
    stepLimit :: Double,
    -- | without a heartbeat, after which the program is ended. It is counted in checks of the owner, so that a pause of this computer
    -- does not end a run; wheels stand after 'watchTimeout' in any case
    abandonLimit :: Double
  }

defaultLimits :: ProcessLimits
defaultLimits = ProcessLimits defaultStepTimeout 3

-- | Runs until the owner leaves. The caller provides an action that receives the next program's socket, which is closed when its run
-- is over, and a writer of lines.
runRobotProcess :: ProcessLimits -> Target -> Recorder -> Connection -> Requests -> IO Socket -> (L.ByteString -> IO ()) -> IO ()
runRobotProcess limits target recorder plain (Requests asked) nextProgram write = do
  let connection = recordedConnection recorder plain
  t0 <- bootSeconds
  runs <- newTQueueIO
  h <-
    RobotProcess
      <$> newTVarIO (snd (haltWheels (targetGuard target)))
      <*> newTVarIO (initialState (profileRobot (targetProfile target)))
      <*> newTVarIO t0
      <*> newTVarIO Nothing
      <*> newTVarIO False
      <*> newTVarIO t0
      <*> newTVarIO 0
      <*> newTVarIO False
      <*> newTVarIO Nothing
      <*> newTVarIO False
      <*> newTVarIO 0
      <*> newTVarIO 0
      <*> newTBQueueIO maxQueuedLines
  sendSettings h target
  sendLine h (linkLine (IsAwaited unknownReason))
  let requests = do
        r <- atomically (readTQueue asked)
        case r of
          Run -> atomically $ do
            number <- stateTVar (requestedRuns h) (\n -> (n + 1, n + 1))
            file <- swapTVar (recordingFile h) Nothing
            writeTQueue runs (number, file)
          Record file -> atomically (writeTVar (recordingFile h) (Just file))
          Stop -> stopRun h >> sendHalt h connection
          EmergencyStop -> emergencyStop h connection
          Free -> atomically (writeTVar (stoppedAt h) Nothing >> modifyTVar' (guarded h) arm) >> reportHeld h
          Safety on -> sendNow connection (stateTVar (guarded h) (setSafetyRules on)) >> sendSettings h target
          Observe on -> atomically (writeTVar (observed h) on)
          Alive seen -> do
            t <- bootSeconds
            -- One that waited while this process or the service stood still counts for nothing.
            when (seen <= t && t - seen < watchTimeout) (atomically (recordHeartbeat h seen))
          Leave -> pure ()
        unless (r == Leave) requests
      programs = do
        next <- atomically ((Left <$> readTQueue runs) `orElse` (Right <$> takeEvents connection))
        case next of
          Right hs -> mapM_ (passEvent h connection) hs
          Left (number, file) -> bracket nextProgram close (\socket -> traverse_ (beginRecording recorder) file >> runProgram (stepLimit limits) target recorder connection h number socket)
        programs
      writer = forever (atomically (readTBQueue (lines' h)) >>= write)
  (requests `race_` programs `race_` writer `race_` sendFrames h `race_` superviseOwner (abandonLimit limits) h connection) `finally` sendHalt h connection

-- | A line for the service; dropped when it does not read.
sendLine :: RobotProcess -> L.ByteString -> IO ()
sendLine h l = atomically $ do
  full <- isFullTBQueue (lines' h)
  unless full (writeTBQueue (lines' h) l)

-- | Sends whether the safety rules are on, and the limits.
sendSettings :: RobotProcess -> Target -> IO ()
sendSettings h target = do
  g <- readTVarIO (guarded h)
  sendLine h (holdingLine (isSafe g) (maxSpeed (targetLimits target)) (maxTurn (targetLimits target)))

-- | The owner was there at this time.
recordHeartbeat :: RobotProcess -> Double -> STM ()
recordHeartbeat h t = modifyTVar' (aliveAt h) (max t) >> writeTVar (silentChecks h) 0

elapsed :: RobotProcess -> IO Double
elapsed h = (-) <$> bootSeconds <*> readTVarIO (began h)

-- | Tells the service about the connection; what the robot's server says goes where the program's texts go.
sendNotice :: RobotProcess -> Notice -> IO ()
sendNotice h n = case n of
  _ | saysText n -> elapsed h >>= \t -> sendLine h (saidLine t (T.unpack (english (explainNotice (tr "The robot") n))))
  _ -> sendLine h (linkLine n)
  where
    saysText what = case what of
      IsComplaining _ -> True
      IsUnreadable _ -> True
      _ -> False

-- | Handles an event of the robot while no program runs.
passEvent :: RobotProcess -> Connection -> RobotEvent -> IO ()
passEvent h connection heard' = do
  was <- isConnected <$> readTVarIO (guarded h)
  case heard' of
    Connected -> sendLine h (linkLine IsThere)
    Disconnected why -> sendLine h (linkLine ((if was then IsLost else IsAwaited) why))
    Refused why -> sendLine h (linkLine (IsRefused why))
    Complained what -> sendNotice h (IsComplaining what)
    Misunderstood what -> sendNotice h (IsUnreadable what)
    Received _ -> pure ()
  sendNow connection $ do
    (ms, actions) <- stateTVar (guarded h) (onEvent heard')
    actions <$ forM_ ms (modifyTVar' (robotState h) . applyMessage)

-- | Halts the wheels.
sendHalt :: RobotProcess -> Connection -> IO ()
sendHalt h connection = sendNow connection (stateTVar (guarded h) haltWheels)

-- | Reports when the wheels begin or cease to be held, by the emergency stop or because the robot of a running program was lost.
reportHeld :: RobotProcess -> IO ()
reportHeld h = atomically $ do
  emergency <- isJust <$> readTVar (stoppedAt h)
  runs <- readTVar (isRunning h)
  mayDrive <- isArmed <$> readTVar (guarded h)
  let isHeld = emergency || (runs && not mayDrive)
  was <- readTVar (toldHeld h)
  full <- isFullTBQueue (lines' h)
  when (isHeld /= was && not full) (writeTVar (toldHeld h) isHeld >> writeTBQueue (lines' h) (stoppedLine isHeld))

-- | Stops the program that runs, and those that were requested and have not begun.
stopRun :: RobotProcess -> IO ()
stopRun h = atomically (readTVar (requestedRuns h) >>= writeTVar (stoppedRuns h))

emergencyStop :: RobotProcess -> Connection -> IO ()
emergencyStop h connection = do
  t <- bootSeconds
  atomically (writeTVar (stoppedAt h) (Just t))
  sendHalt h connection
  reportHeld h
  stopRun h

-- | The run of this number.
runProgram :: Double -> Target -> Recorder -> Connection -> RobotProcess -> Int -> Socket -> IO ()
runProgram stepLimit' target recorder connection h number socket = do
  t <- bootSeconds
  mayBegin <- atomically $ do
    mayBegin <- (&&) <$> (isNothing <$> readTVar (stoppedAt h)) <*> (not <$> isStopped)
    when mayBegin $ do
      writeTVar (isRunning h) True
      recordHeartbeat h t
      writeTVar (began h) t
      modifyTVar' (guarded h) startRun
      modifyTVar' (robotState h) restart
    pure mayBegin
  if not mayBegin
    then endRecording recorder >> sendLine h (endedLine 0 "stopped" Nothing)
    else do
      pace <- realPace stepLimit'
      served <- runLockstep pace (observer h) {onLines = recordLines recorder} isStopped Nothing (targetPatience target) (guarded h) connection socket `finally` atomically (writeTVar (isRunning h) False)
      time <- elapsed h
      endRecording recorder
      sendFrame h
      counts <- atomically (unreadableMessages connection)
      forM_ (unreadableSentences counts) (sendLine h . saidLine time . T.unpack . english)
      sendLine h . uncurry (endedLine time) $ case runEnd served of
        Finished -> ("done", Nothing)
        Stopped -> ("stopped", Nothing)
        Failed _ _ (Just p) -> ("error", Just p)
        Failed {} -> ("broken", Nothing)
        Stuck -> ("stuck", Nothing)
        Died -> ("died", Nothing)
        RobotLost _ -> ("lost", Nothing)
        RobotRefused _ -> ("lost", Nothing)
        NeverRan -> ("stopped", Nothing)
  where
    isStopped = (number <=) <$> readTVar (stoppedRuns h)

observer :: RobotProcess -> Observer
observer h =
  Observer
    { onMessages = \ms -> atomically (modifyTVar' (robotState h) (\p -> foldl (flip applyMessage) p ms)),
      onProgramCommand = \a -> do
        t <- elapsed h
        atomically (modifyTVar' (robotState h) (applyCommand a))
        case a of
          SayCommand (Say s) -> sendLine h (saidLine t s)
          SoundCommand s -> sendLine h (soundLine t s)
          _ -> pure (),
      onSettled = \(SettledStep (StepReport fired sent told) commands) -> do
        atomically (modifyTVar' (robotState h) (recordFirings fired))
        backing <- isEvading <$> readTVarIO (guarded h)
        unless (null commands && isNothing told) $ do
          t <- elapsed h
          sendLine h (commandsLine t fired sent commands ((,) backing <$> told)),
      observes = readTVarIO (observed h),
      onNotice = sendNotice h,
      onLines = \_ _ -> pure ()
    }

-- | Sends fifty frames a second, the rate at which the robot senses.
sendFrames :: RobotProcess -> IO ()
sendFrames h = forever (threadDelay 20000 >> sendFrame h)

sendFrame :: RobotProcess -> IO ()
sendFrame h = do
  t <- elapsed h
  l <- atomically $ do
    here' <- readTVar (guarded h)
    stateTVar (robotState h) (frameLine t (isEvading here'))
  sendLine h l

-- | Lets the wheels turn while heartbeats arrive, reports when they are held, and repeats an emergency stop for a second.
superviseOwner :: Double -> RobotProcess -> Connection -> IO ()
superviseOwner abandonLimit' h connection = forever $ do
  threadDelay (ceiling (checkInterval * 1e6))
  t <- bootSeconds
  seen <- readTVarIO (aliveAt h)
  silent <- atomically (stateTVar (silentChecks h) (\n -> (n + 1, n + 1)))
  runs <- readTVarIO (isRunning h)
  when runs $ do
    sendNow connection (stateTVar (guarded h) (setWatched (t - seen < watchTimeout)))
    -- A page that was away for so long does not let the robot drive on by coming back.
    when (t - seen > longestAbsence) (atomically (modifyTVar' (guarded h) disarm))
    when (fromIntegral silent * checkInterval > abandonLimit') (stopRun h >> sendHalt h connection)
  reportHeld h
  stopped <- readTVarIO (stoppedAt h)
  forM_ stopped $ \since -> when (t - since < 1) (sendHalt h connection)
