{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.Serve
-- Description : A real robot in the simulator's place.
--
-- In: a socket at whose other end a program waits for the simulator, and a robot. Out: how it ended. The program runs
-- where learners' programs run, in its sandbox, and never learns that the robot is real: it is told of steps of 20 ms, with
-- the real time, and the robot is told what the guard lets through. A program that does not answer a step is given up.
module Rosy.Robots.Serve
  ( serve,
    Pace (..),
    realPace,
    Witness (..),
    onTerminal,
    Served (..),
    HowEnded (..),
  )
where

import Control.Concurrent (threadDelay, threadWaitRead)
import Control.Concurrent.STM
import Control.Exception (IOException, try)
import Control.Monad (forM_, unless, when)
import Data.Aeson (Value)
import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as C
import Data.IORef
import Data.Text (Text)
import Data.Time.Clock.POSIX (getPOSIXTime)
import GHC.Clock (getMonotonicTime)
import Network.Socket (Socket, withFdSocket)
import Network.Socket.ByteString (recv)
import Network.Socket.ByteString.Lazy (sendAll)
import Rosy.Core (Action (..), Message (..), Odometry (..))
import Rosy.Robot (Orientation (..), Position (..))
import Rosy.Robots.Base
import Rosy.Robots.Guard
import Rosy.Robots.Pipe
import System.IO (hPutStrLn, stderr)
import System.Posix.Types (Fd (..))
import System.Random (randomRIO)

-- | Who is told what happens; none of it may wait.
data Witness = Witness
  { -- | what the program hears, in its own frame
    hears :: [Message] -> IO (),
    -- | what the program wants, whether or not the robot may be told
    wants :: Action -> IO (),
    -- | the names of the functions that fired in a step
    fires :: [Text] -> IO (),
    -- | the robot is awaited, lost or back
    noticed :: Notice -> IO ()
  }

-- | For a person at a terminal: the program's words go to standard output, the robot's state to standard error.
onTerminal :: String -> Witness
onTerminal name =
  Witness
    { hears = const (pure ()),
      wants = \case
        SayText s -> putStrLn s
        _ -> pure (),
      fires = const (pure ()),
      noticed = hPutStrLn stderr . explainNotice name
    }

data Served = Served
  { how :: HowEnded,
    -- | steps that the program has answered
    stepsServed :: Int,
    -- | where the robot was last, from where it started
    lastPose :: Maybe (Position, Orientation)
  }

data HowEnded
  = ByItself
  | Asked
  | -- | what a person should know, and what to do; the problem as the program told it
    InError Text Text (Maybe Value)
  | -- | it did not answer
    IsStuck
  | -- | the program is gone without a word
    IsDead
  | -- | the robot is gone, for this reason
    RobotLost String
  deriving (Eq, Show)

-- | Chance and time, as the run has them.
data Pace = Pace
  { -- | where the chance of this run comes from
    chance :: IO Int,
    -- | seconds since 1970
    timeNow :: IO Double,
    -- | waits until the next step begins
    awaitStep :: IO ()
  }

-- | Fifty steps a second from now on. One that came late is not caught up with.
realPace :: IO Pace
realPace = do
  due <- getMonotonicTime >>= newIORef
  pure
    Pace
      { chance = randomRIO (0, 2 ^ (31 :: Int) - 1),
        timeNow = realToFrac <$> getPOSIXTime,
        awaitStep = do
          t <- getMonotonicTime
          begins <- max (t - stepLength) <$> readIORef due
          when (begins > t) (threadDelay (ceiling ((begins - t) * 1e6)))
          writeIORef due (begins + stepLength)
      }

-- | How long a program may think, microseconds. Longer than 0.6 s, after which the base has stopped by itself.
thinking :: Int
thinking = 1000000

-- | A step, seconds (protocol/README.md).
stepLength :: Double
stepLength = 0.02

-- | Steps from one tick of the default rate to the next (protocol/README.md).
tickSteps :: Int
tickSteps = 5

-- | Serves until the program or the person has had enough. The number is how many seconds a lost robot is waited for.
serve :: Pace -> Witness -> STM Bool -> Double -> TVar Guard -> Base -> Socket -> IO Served
serve pace witness stopWanted patience guarded base socket = do
  unread <- newIORef B.empty
  pose <- newIORef Nothing
  lost <- newIORef Nothing
  let guarding :: (Guard -> (b, Guard)) -> IO b
      guarding f = atomically (stateTVar guarded f)
      now = timeNow pace
      -- The next line of the program; nothing when it is gone or takes too long.
      line = do
        bytes <- readIORef unread
        case C.elemIndex '\n' bytes of
          Just i -> Right (B.take i bytes) <$ writeIORef unread (B.drop (i + 1) bytes)
          Nothing -> do
            some <- patiently thinking (withFdSocket socket (threadWaitRead . Fd))
            case some of
              Nothing -> pure (Left IsStuck)
              Just () ->
                try (recv socket 65536) >>= \case
                  Left e -> Left IsDead <$ pure (e :: IOException)
                  Right b
                    | B.null b -> pure (Left IsDead)
                    | otherwise -> writeIORef unread (bytes <> b) >> line
      -- Carries out what it wants until it has settled.
      listen = do
        heard' <- line
        case heard' of
          Left e -> pure (Just e)
          Right bytes -> case readWish bytes of
            Just (Wants a) -> carry a >> listen
            Just NamesTopics -> listen
            Just Ready -> pure Nothing
            Just (Settled fired) -> Nothing <$ unless (null fired) (fires witness fired)
            Just (HasEnded "error" p) -> pure (Just (maybe (InError "The program failed." "" Nothing) (\(m, hint, v) -> InError m hint (Just v)) p))
            Just (HasEnded "stopped" _) -> pure (Just Asked)
            Just (HasEnded _ _) -> pure (Just ByItself)
            Nothing -> pure (Just (InError "The program said something that a robot does not understand." "" Nothing))
      carry a = do
        wants witness a
        t <- now
        guarding (commanding t a) >>= mapM_ (tell base)
      say builder = try (sendAll socket (Builder.toLazyByteString builder)) >>= either (\(_ :: IOException) -> pure ()) pure
      -- What came, for the program; what a person should know, on the terminal.
      passes h = do
        wasHere <- isHere <$> readTVarIO guarded
        case h of
          Gone why
            | wasHere -> noticed witness (IsLost why) >> now >>= \t -> writeIORef lost (Just (t, why))
            | otherwise -> noticed witness (IsAwaited why)
          Here -> do
            l <- readIORef lost
            noticed witness (if null l then IsThere else IsBack)
            writeIORef lost Nothing
          Heard _ -> pure ()
        (ms, actions) <- guarding (hearing h)
        mapM_ (tell base) actions
        unless (null ms) (hears witness ms)
        forM_ ms $ \case
          OdometryMessage o -> writeIORef pose (Just (odometryPosition o, odometryOrientation o))
          _ -> pure ()
        pure ms
      untilHere early = do
        hs <- atomically ((Nothing <$ (stopWanted >>= check)) `orElse` (Just <$> hear base))
        case hs of
          Nothing -> pure early
          Just some -> do
            ms <- concat <$> mapM passes some
            there <- isHere <$> readTVarIO guarded
            if there then pure (early ++ ms) else untilHere (early ++ ms)
      steps n early = do
        awaitStep pace
        stop <- atomically stopWanted
        l <- readIORef lost
        t <- now
        case l of
          _ | stop -> ended n =<< (say stopLine >> listenToTheEnd)
          Just (since, why) | t - since > patience -> say stopLine >> ended n (RobotLost why)
          _ -> do
            some <- atomically (hear base `orElse` pure [])
            ms <- (early ++) . concat <$> mapM passes some
            say (batchLines n t ms)
            outcome <- listen
            case outcome of
              Just e -> ended n e
              Nothing -> do
                when (n `mod` tickSteps == 0) (now >>= \t' -> guarding (ticking t') >>= mapM_ (tell base))
                steps (n + 1) []
      listenToTheEnd = listen >>= maybe listenToTheEnd pure
      ended n e = do
        guarding halting >>= mapM_ (tell base)
        Served e n <$> readIORef pose
  -- A robot that is held already is here.
  there <- isHere <$> readTVarIO guarded
  early <- if there then pure [] else noticed witness (IsAwaited "") >> untilHere []
  chance pace >>= say . startLine
  opened <- listen
  maybe (steps 0 early) (ended 0) opened
