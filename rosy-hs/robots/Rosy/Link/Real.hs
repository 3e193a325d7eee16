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
import Control.Monad (forM_, when, (>=>))
import Data.IORef
import Data.Maybe (isNothing)
import qualified Data.Text as T
import GHC.Clock (getMonotonicTime)
import Rosy.Channel (Message)
import Rosy.Link
import Rosy.Problem (Fault (..))
import Rosy.Robot
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.Wording (tellPerson)
import Rosy.Sentence (english)
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
haltRobot r connection = atomically (stateTVar (guarded r) haltWheels) >>= mapM_ (sendCommand connection)

data Clock = Clock
  { -- | seconds of a clock that runs while the computer sleeps
    now :: IO Double,
    -- | the time of day, seconds
    today :: IO Double,
    -- | becomes true when a tick is due; taking the tick resets it
    tickDue :: TVar Bool
  }

-- | The system's clocks, and ten ticks a second (the default rate, rule R3) while the action runs. A program that
-- is late gets one tick, not all that it has missed.
withClock :: (Clock -> IO a) -> IO a
withClock use = do
  due <- newTVarIO False
  began <- getMonotonicTime
  let beat n = do
        t <- getMonotonicTime
        threadDelay (max 0 (ceiling ((began + fromIntegral n / 10 - t) * 1e6)))
        atomically (writeTVar due True)
        beat (n + 1 :: Int)
  withAsync (beat 1) (const (use (Clock bootSeconds secondsOfDay due)))

-- | The robot as a link. The number is how many seconds a lost robot is waited for before the run ends.
realLink :: Clock -> Double -> RunControl -> Connection -> IO Link
realLink clock patience r connection = do
  steps <- newIORef 0
  early <- newIORef []
  ticked <- newIORef False
  lostSince <- newIORef Nothing
  beganAt <- newIORef 0
  let guarding :: (Guard -> (b, Guard)) -> IO b
      guarding f = atomically (stateTVar (guarded r) f)
      -- Messages of an event for the program, in order; notices go to the terminal.
      passes :: RobotEvent -> IO [Message]
      passes h = do
        wasHere <- isConnected <$> readTVarIO (guarded r)
        case h of
          Disconnected why | wasHere -> do
            complain (IsLost why)
            t <- now clock
            writeIORef lostSince (Just (t, why))
          Disconnected why -> complain (IsAwaited why)
          Refused why -> complain (IsRefused why) >> atomically (writeTVar (refused r) True) >> throwIO (LinkLost (T.unpack (english why)))
          Connected -> do
            lost <- readIORef lostSince
            complain (if isNothing lost then IsThere else IsBack)
            writeIORef lostSince Nothing
          Complained what -> complain (IsComplaining what)
          Misunderstood what -> complain (IsUnreadable what)
          Received _ -> pure ()
        (messages, actions) <- guarding (onEvent h)
        messages <$ mapM_ (sendCommand connection) actions
      -- The time is read for each command: this process may be suspended between two of them.
      drive a = do
        case a of
          SayCommand (Say s) -> putStrLn s
          _ -> pure ()
        forM_ (resolveCommand connection a) $ \a' -> now clock >>= \t -> guarding (onCommand t a') >>= mapM_ (sendCommand connection)
      untilHere = do
        found <- atomically $ do
          stop <- readTVar (stopWanted r)
          if stop then pure Nothing else Just <$> takeEvents connection
        forM_ found $ \hs -> do
          ms <- concat <$> mapM passes hs
          modifyIORef' early (++ withoutEvents ms)
          arrived <- isConnected <$> readTVarIO (guarded r)
          if arrived then pure () else untilHere
      following = do
        waiting <- readIORef early
        found <- atomically $ do
          stop <- readTVar (stopWanted r)
          if stop
            then pure Nothing
            else do
              hs <- takeEvents connection `orElse` pure []
              tick <- swapTVar (tickDue clock) False
              check (tick || not (null hs && null waiting))
              pure (Just (hs, tick))
        case found of
          Nothing -> pure Nothing
          Just (hs, tick) -> do
            t <- now clock
            ms <- (++) <$> atomicModifyIORef' early ([],) <*> (concat <$> mapM passes hs)
            lost <- readIORef lostSince
            forM_ lost $ \(since, why) -> when (t - since > patience) (throwIO (LinkLost (T.unpack (english why))))
            if null ms && not tick
              then following
              else do
                n <- atomicModifyIORef' steps (\i -> (i + 1, i))
                writeIORef ticked tick
                since <- readIORef beganAt
                pure (Just (Batch n (t - since) ms tick False False False))
  pure
    Link
      { open = \topics -> do
          registerTopics connection topics >>= mapM_ tellPerson
          complain (IsAwaited unknownReason)
          untilHere
          now clock >>= writeIORef beganAt
          Opening <$> randomIO <*> today clock,
        next = following,
        answer = \a -> do
          mapM_ drive (answerActions a)
          tick <- readIORef ticked
          when tick $ do
            t <- now clock
            guarding (onTick t) >>= mapM_ (sendCommand connection)
            guarding (noticeMotion t) >>= mapM_ (motionNotice connection >=> complain),
        end = \a _ -> do
          mapM_ drive (answerActions a)
          haltRobot r connection,
        atWork = const (pure ()),
        atRest = pure ()
      }
  where
    complain = tellPerson . explainNotice (connectionName connection)
