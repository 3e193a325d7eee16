-- |
-- Module      : Rosy.Link.Real
-- Description : The link to a real robot, independent of its transport.
--
-- A program on a real robot gets messages as they arrive, with ten ticks a second in between; nothing waits for it.
-- All commands pass the guard ("Rosy.Robots.Guard"). A velocity is repeated by the program's own
-- loop and by nothing else: when the program hangs, the base gets no commands and stops by itself.
module Rosy.Link.Real
  ( -- * The link
    realLink,

    -- * Control of a run
    RunControl,
    newRunControl,
    runGuard,
    wasRefused,
    requestStop,
    haltRobot,

    -- * Time
    Clock (..),
    withClock,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM
import Control.Exception (throwIO)
import Control.Monad (forM_, unless, when, (>=>))
import Data.IORef
import Data.Maybe (isNothing)
import qualified Data.Text as T
import GHC.Clock (getMonotonicTime)
import Rosy.Channel (Action, Message)
import Rosy.Core (Topic)
import Rosy.Link
import Rosy.Problem (Fault (..))
import Rosy.Robot
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.Wording (tellPerson)
import Rosy.Sentence (Sentence, english)
import System.Random (randomIO)

-- | Control of a run from outside: the stop flag, the guard, and whether the robot was refused.
data RunControl = RunControl {stopWanted :: TVar Bool, guarded :: TVar Guard, refused :: TVar Bool}

newRunControl :: Guard -> IO RunControl
newRunControl g = RunControl <$> newTVarIO False <*> newTVarIO g <*> newTVarIO False

-- | The guard of the run.
runGuard :: RunControl -> TVar Guard
runGuard = guarded

-- | Whether the run ended because the robot can never be driven; a person has been told why.
wasRefused :: RunControl -> IO Bool
wasRefused = readTVarIO . refused

-- | Requests an orderly end of the program.
requestStop :: RunControl -> IO ()
requestStop r = atomically (writeTVar (stopWanted r) True)

-- | Halts the wheels; later commands of the program have no effect.
haltRobot :: RunControl -> Connection -> IO ()
haltRobot r robot = sendNow robot (stateTVar (guarded r) haltWheels)

data Clock = Clock
  { -- | seconds of a clock that runs while the computer sleeps
    now :: IO Double,
    -- | the time of day, seconds
    today :: IO Double,
    -- | starts the ticks; the first is due at once
    startTicks :: IO (),
    -- | becomes true when a tick is due; taking the tick resets it
    tickDue :: TVar Bool
  }

-- | The system's clocks, and ten ticks a second (the default rate, rule R3) from 'startTicks' on while the action runs.
-- A program that is late gets one tick, not all that it has missed.
withClock :: (Clock -> IO a) -> IO a
withClock use = do
  due <- newTVarIO False
  started <- newTVarIO False
  let beat began n = do
        atomically (writeTVar due True)
        t <- getMonotonicTime
        threadDelay (max 0 (ceiling ((began + fromIntegral (n :: Int) / 10 - t) * 1e6)))
        beat began (n + 1)
      beats = atomically (readTVar started >>= check) >> getMonotonicTime >>= \began -> beat began 1
  withAsync beats (const (use (Clock bootSeconds secondsOfDay (atomically (writeTVar started True)) due)))

-- | A run as a link sees it: what it was opened with, and what changes.
data RealRun = RealRun
  { clock :: Clock,
    -- | how many seconds a lost robot is waited for before the run ends
    patience :: Double,
    control :: RunControl,
    connection :: Connection,
    -- | steps that have begun
    steps :: IORef Int,
    -- | messages for the program from before its first step
    early :: IORef [Message],
    -- | whether the program got a tick with its last step
    ticked :: IORef Bool,
    -- | when the robot was lost, and why
    lostSince :: IORef (Maybe (Double, Sentence)),
    -- | when the robot was there, by the clock
    beganAt :: IORef Double
  }

-- | The robot as a link. The number is how many seconds a lost robot is waited for before the run ends.
realLink :: Clock -> Double -> RunControl -> Connection -> IO Link
realLink clock' seconds control' connection' = do
  run <- RealRun clock' seconds control' connection' <$> newIORef 0 <*> newIORef [] <*> newIORef False <*> newIORef Nothing <*> newIORef 0
  pure
    Link
      { open = openRobot run,
        next = nextBatch run,
        answer = answerBatch run,
        end = \a _ -> do
          mapM_ (drive run) (answerActions a)
          cancelGoals connection'
          haltRobot control' connection',
        atWork = const (pure ()),
        atRest = pure ()
      }

-- | Waits for the robot.
openRobot :: RealRun -> [Topic] -> IO Opening
openRobot run topics = do
  registerTopics (connection run) topics >>= mapM_ tellPerson
  complain run (IsAwaited unknownReason)
  awaitRobot run
  now (clock run) >>= writeIORef (beganAt run)
  -- The first tick is at 0 s of the program, and the second 0.1 s later, however long the robot was waited for.
  startTicks (clock run)
  Opening <$> randomIO <*> today (clock run)

-- | Until the robot is there, or the run is to stop.
awaitRobot :: RealRun -> IO ()
awaitRobot run = do
  found <- atomically $ do
    stop <- readTVar (stopWanted (control run))
    if stop then pure Nothing else Just <$> takeEvents (connection run)
  forM_ found $ \hs -> do
    ms <- concat <$> mapM (passes run) hs
    modifyIORef' (early run) (++ withoutEvents ms)
    arrived <- isConnected <$> readTVarIO (guarded (control run))
    if arrived then pure () else awaitRobot run

-- | The next step of the program; nothing when the run is to stop.
nextBatch :: RealRun -> IO (Maybe Batch)
nextBatch run = do
  waiting <- readIORef (early run)
  found <- atomically $ do
    stop <- readTVar (stopWanted (control run))
    if stop
      then pure Nothing
      else do
        hs <- takeEvents (connection run) `orElse` pure []
        tick <- swapTVar (tickDue (clock run)) False
        check (tick || not (null hs && null waiting))
        pure (Just (hs, tick))
  case found of
    Nothing -> pure Nothing
    Just (hs, tick) -> do
      t <- now (clock run)
      arrived <- (++) <$> atomicModifyIORef' (early run) ([],) <*> (concat <$> mapM (passes run) hs)
      (ms, actions) <- guarding run (freshMessages t arrived)
      mapM_ (sendCommand (connection run) t) actions
      lost <- readIORef (lostSince run)
      forM_ lost $ \(since, why) -> when (t - since > patience run) (throwIO (LinkLost (T.unpack (english why))))
      if null ms && not tick
        then nextBatch run
        else do
          n <- atomicModifyIORef' (steps run) (\i -> (i + 1, i))
          writeIORef (ticked run) tick
          since <- readIORef (beganAt run)
          pure (Just (Batch n (t - since) ms tick False False False))

-- | Carries out what the program answers, and with a tick what the guard does.
answerBatch :: RealRun -> Answer -> IO ()
answerBatch run a = do
  mapM_ (drive run) (answerActions a)
  tick <- readIORef (ticked run)
  when tick $ do
    t <- now (clock run)
    guarding run (onTick t) >>= mapM_ (sendCommand (connection run) t)
    drives <- mayBeDriven <$> readTVarIO (guarded (control run))
    unless drives (cancelGoals (connection run))
    guarding run (noticeMotion t) >>= mapM_ (motionNotice (connection run) >=> complain run)

-- | Messages of an event for the program, in order; notices go to the terminal.
passes :: RealRun -> RobotEvent -> IO [Message]
passes run h = do
  t <- now (clock run)
  wasHere <- isConnected <$> readTVarIO (guarded (control run))
  case h of
    Disconnected why | wasHere -> do
      complain run (IsLost why)
      writeIORef (lostSince run) (Just (t, why))
    Disconnected why -> complain run (IsAwaited why)
    Refused why -> complain run (IsRefused why) >> atomically (writeTVar (refused (control run)) True) >> throwIO (LinkLost (T.unpack (english why)))
    Connected -> do
      lost <- readIORef (lostSince run)
      complain run (if isNothing lost then IsThere else IsBack)
      writeIORef (lostSince run) Nothing
    Complained what -> complain run (IsComplaining what)
    Misunderstood what -> complain run (IsUnreadable what)
    Received _ -> pure ()
  (messages, actions) <- guarding run (onEvent h)
  messages <$ mapM_ (sendCommand (connection run) t) actions

-- | Carries out a command. The time is read for each: this process may be suspended between two of them.
drive :: RealRun -> Action -> IO ()
drive run a = do
  case a of
    SayCommand (Say s) -> putStrLn s
    _ -> pure ()
  drives <- mayBeDriven <$> readTVarIO (guarded (control run))
  case callsServer a of
    Just frame | not drives -> refuseCall (connection run) frame mayNotDrive
    _ -> forM_ (resolveCommand (connection run) a) $ \a' -> now (clock run) >>= \t -> guarding run (onCommand t a') >>= mapM_ (sendCommand (connection run) t)

guarding :: RealRun -> (Guard -> (b, Guard)) -> IO b
guarding run f = atomically (stateTVar (guarded (control run)) f)

complain :: RealRun -> Notice -> IO ()
complain run = tellPerson . explainNotice (connectionName (connection run))
