-- |
-- Module      : Rosy.Link.Real
-- Description : The link to a real robot, whichever way it is reached.
--
-- A program on a real robot hears what comes as it comes, with ten ticks a second in between; nothing waits for it.
-- Everything it wants passes the guard ("Rosy.Robots.Guard"). A velocity is repeated by the program's own
-- turning loop and by nothing else: when the program hangs, the base hears nothing more and stops by itself.
module Rosy.Link.Real
  ( -- * The link
    realLink,

    -- * What a person holds
    Reins,
    newReins,
    stopAsked,
    halt,

    -- * Time
    Clock (..),
    withClock,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM
import Control.Exception (throwIO)
import Control.Monad (forM_, when)
import Data.IORef
import Data.Maybe (isNothing)
import Data.Time.Clock.POSIX (getPOSIXTime)
import GHC.Clock (getMonotonicTime)
import Rosy.Core (Action (..), Message)
import Rosy.Link
import Rosy.Problem (Fault (..))
import Rosy.Robots.Base
import Rosy.Robots.Guard
import System.IO (hPutStrLn, stderr)
import System.Random (randomIO)

-- | What a person holds while a program drives: the wish to stop, and the guard.
data Reins = Reins {stopWanted :: TVar Bool, guarded :: TVar Guard}

newReins :: Guard -> IO Reins
newReins g = Reins <$> newTVarIO False <*> newTVarIO g

-- | The program is to end in good order.
stopAsked :: Reins -> IO ()
stopAsked r = atomically (writeTVar (stopWanted r) True)

-- | The wheels stand from now on, whatever the program is doing.
halt :: Reins -> Base -> IO ()
halt r base = atomically (stateTVar (guarded r) halting) >>= mapM_ (tell base)

data Clock = Clock
  { -- | seconds since 1970
    now :: IO Double,
    -- | becomes true when a tick is due; who takes the tick sets it back
    tickDue :: TVar Bool
  }

-- | The system's time, and ten ticks a second (LANGUAGE: the default rate) while the action runs. A program that
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
  withAsync (beat 1) (const (use (Clock (realToFrac <$> getPOSIXTime) due)))

-- | The robot as a link. The number is how many seconds a lost robot is waited for before the run ends.
realLink :: Clock -> Double -> Reins -> Base -> IO Link
realLink clock patience r base = do
  steps <- newIORef 0
  early <- newIORef []
  ticked <- newIORef False
  lostSince <- newIORef Nothing
  let guarding :: (Guard -> (b, Guard)) -> IO b
      guarding f = atomically (stateTVar (guarded r) f)
      -- What the program is to hear, in order; what a person should know goes to the terminal.
      passes :: Heard -> IO [Message]
      passes h = do
        wasHere <- isHere <$> readTVarIO (guarded r)
        case h of
          Gone why | wasHere -> do
            complain (IsLost why)
            t <- now clock
            writeIORef lostSince (Just (t, why))
          Gone why -> complain (IsAwaited why)
          Here -> do
            lost <- readIORef lostSince
            complain (if isNothing lost then IsThere else IsBack)
            writeIORef lostSince Nothing
          Heard _ -> pure ()
        (messages, actions) <- guarding (hearing h)
        messages <$ mapM_ (tell base) actions
      drive t a = do
        case a of
          SayText s -> putStrLn s
          _ -> pure ()
        guarding (commanding t a) >>= mapM_ (tell base)
      untilHere = do
        found <- atomically $ do
          stop <- readTVar (stopWanted r)
          if stop then pure Nothing else Just <$> hear base
        forM_ found $ \hs -> do
          ms <- concat <$> mapM passes hs
          modifyIORef' early (++ ms)
          arrived <- isHere <$> readTVarIO (guarded r)
          if arrived then pure () else untilHere
      following = do
        waiting <- readIORef early
        found <- atomically $ do
          stop <- readTVar (stopWanted r)
          if stop
            then pure Nothing
            else do
              hs <- hear base `orElse` pure []
              tick <- swapTVar (tickDue clock) False
              check (tick || not (null hs && null waiting))
              pure (Just (hs, tick))
        case found of
          Nothing -> pure Nothing
          Just (hs, tick) -> do
            t <- now clock
            ms <- (++) <$> atomicModifyIORef' early ([],) <*> (concat <$> mapM passes hs)
            lost <- readIORef lostSince
            forM_ lost $ \(since, why) -> when (t - since > patience) (throwIO (LinkLost why))
            if null ms && not tick
              then following
              else do
                n <- atomicModifyIORef' steps (\i -> (i + 1, i))
                writeIORef ticked tick
                pure (Just (Batch n t ms tick False))
  pure
    Link
      { open = do
          complain (IsAwaited "")
          untilHere
          Opening <$> randomIO,
        next = following,
        answer = \a -> do
          t <- now clock
          mapM_ (drive t) (answerActions a)
          tick <- readIORef ticked
          when tick (guarding (ticking t) >>= mapM_ (tell base)),
        end = \a _ -> do
          t <- now clock
          mapM_ (drive t) (answerActions a)
          halt r base,
        atWork = const (pure ()),
        atRest = pure ()
      }
  where
    complain = hPutStrLn stderr . explainNotice (baseName base)
