{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.Hold
-- Description : A real robot, held by somebody, for one program after another.
--
-- In: a robot, the lines of @protocol/README.md@ section 7 from the service, and programs' sockets. Out: what the robot
-- does, as lines. The robot is connected and watched before the first program, between programs and after the last. Its
-- wheels turn only while a program runs, somebody watches, and no emergency stop holds them.
module Rosy.Robots.Hold
  ( hold,
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
import Data.Maybe (isNothing)
import Data.Text (Text)
import GHC.Clock (getMonotonicTime)
import Network.Socket (Socket, close)
import Rosy.Core (Action (..))
import Rosy.Robots.Base
import Rosy.Robots.Guard
import Rosy.Robots.Serve
import Rosy.Robots.Target (Target (..))
import Rosy.Robots.Telemetry

data Request
  = -- | a program waits at the next socket
    Run
  | Stop
  | EmergencyStop
  | -- | the emergency stop is over
    Free
  | -- | somebody watches
    Alive
  | -- | nobody holds the robot any more
    Leave
  deriving (Eq, Show)

-- | Nothing for a line that protocol/README.md does not have.
readRequest :: ByteString -> Maybe Request
readRequest bytes = case Aeson.decodeStrict' bytes of
  Just (Object o) -> parseMaybe (.: "op") o >>= (`lookup` ops)
  _ -> Nothing
  where
    ops = [("run" :: Text, Run), ("stop", Stop), ("estop", EmergencyStop), ("free", Free), ("alive", Alive)]

-- | What has been asked for and is not done yet.
newtype Requests = Requests (TQueue Request)

newRequests :: IO Requests
newRequests = Requests <$> newTQueueIO

request :: Requests -> Request -> IO ()
request (Requests queue) = atomically . writeTQueue queue

data Hold = Hold
  { guarded :: TVar Guard,
    picture :: TVar Picture,
    -- | when what is shown began: the hold, then each run; monotonic seconds
    began :: TVar Double,
    -- | the emergency stop holds the wheels, since then
    stoppedAt :: TVar (Maybe Double),
    -- | when somebody last said that they watch
    aliveAt :: TVar Double,
    -- | the wish to stop the program that runs
    running :: TVar (Maybe (TVar Bool)),
    lines' :: TBQueue L.ByteString
  }

-- | Lines that wait for a service that does not read; more are dropped.
mostLines :: Num n => n
mostLines = 1000

-- | Seconds without a sign that somebody watches, after which the wheels stand. With the network's way and the twentieth of a
-- second in which it is noticed they stand within 0.7 s.
unwatched :: Double
unwatched = 0.5

-- | And after which the program is ended.
deserted :: Double
deserted = 3

-- | Until somebody leaves. How to get the next program's socket, which is closed when its run is over, and a writer of lines are
-- the caller's.
hold :: Target -> Base -> Requests -> IO Socket -> (L.ByteString -> IO ()) -> IO ()
hold target base (Requests asked) nextProgram write = do
  t0 <- getMonotonicTime
  runs <- newTQueueIO
  h <-
    Hold
      <$> newTVarIO (snd (halting (newGuard (targetLimits target) (targetSafety target))))
      <*> newTVarIO blank
      <*> newTVarIO t0
      <*> newTVarIO Nothing
      <*> newTVarIO t0
      <*> newTVarIO Nothing
      <*> newTBQueueIO mostLines
  tellLine h (holdingLine (targetSafety target) (maxSpeed (targetLimits target)) (maxTurn (targetLimits target)))
  tellLine h (linkLine (IsAwaited ""))
  let requests = do
        r <- atomically (readTQueue asked)
        case r of
          Run -> atomically (writeTQueue runs ())
          Stop -> stopRun h >> standing h base
          EmergencyStop -> emergency h base
          Free -> atomically (writeTVar (stoppedAt h) Nothing) >> tellLine h (stoppedLine False)
          Alive -> getMonotonicTime >>= atomically . writeTVar (aliveAt h)
          Leave -> pure ()
        unless (r == Leave) requests
      programs = do
        next <- atomically ((Nothing <$ readTQueue runs) `orElse` (Just <$> hear base))
        case next of
          Just hs -> mapM_ (passing h base) hs
          Nothing -> bracket nextProgram close (runProgram target base h)
        programs
      writer = forever (atomically (readTBQueue (lines' h)) >>= write)
  (requests `race_` programs `race_` writer `race_` painting h `race_` watchingOver h base) `finally` standing h base

-- | A line for the service; dropped when it does not read.
tellLine :: Hold -> L.ByteString -> IO ()
tellLine h l = atomically $ do
  full <- isFullTBQueue (lines' h)
  unless full (writeTBQueue (lines' h) l)

sinceBegan :: Hold -> IO Double
sinceBegan h = (-) <$> getMonotonicTime <*> readTVarIO (began h)

-- | What the robot says while no program runs.
passing :: Hold -> Base -> Heard -> IO ()
passing h base heard' = do
  was <- isHere <$> readTVarIO (guarded h)
  case heard' of
    Here -> tellLine h (linkLine IsThere)
    Gone why -> tellLine h (linkLine ((if was then IsLost else IsAwaited) why))
    Heard _ -> pure ()
  actions <- atomically $ do
    (ms, actions) <- stateTVar (guarded h) (hearing heard')
    actions <$ forM_ ms (modifyTVar' (picture h) . sensed)
  mapM_ (tell base) actions

-- | The wheels stand.
standing :: Hold -> Base -> IO ()
standing h base = atomically (stateTVar (guarded h) halting) >>= mapM_ (tell base)

stopRun :: Hold -> IO ()
stopRun h = atomically (readTVar (running h) >>= mapM_ (`writeTVar` True))

emergency :: Hold -> Base -> IO ()
emergency h base = do
  t <- getMonotonicTime
  atomically (writeTVar (stoppedAt h) (Just t))
  standing h base
  tellLine h (stoppedLine True)
  stopRun h

runProgram :: Target -> Base -> Hold -> Socket -> IO ()
runProgram target base h socket = do
  stop <- newTVarIO False
  t <- getMonotonicTime
  held <- atomically $ do
    held <- readTVar (stoppedAt h)
    when (isNothing held) $ do
      writeTVar (running h) (Just stop)
      writeTVar (aliveAt h) t
      writeTVar (began h) t
      modifyTVar' (guarded h) renewing
      modifyTVar' (picture h) restarted
    pure held
  case held of
    Just _ -> tellLine h (endedLine 0 "stopped" Nothing)
    Nothing -> do
      pace <- realPace
      served <- serve pace (witness h) (readTVar stop) (targetPatience target) (guarded h) base socket `finally` atomically (writeTVar (running h) Nothing)
      time <- sinceBegan h
      showFrame h
      tellLine h . uncurry (endedLine time) $ case how served of
        ByItself -> ("done", Nothing)
        Asked -> ("stopped", Nothing)
        InError _ _ (Just p) -> ("error", Just p)
        InError {} -> ("broken", Nothing)
        IsStuck -> ("stuck", Nothing)
        IsDead -> ("died", Nothing)
        RobotLost _ -> ("lost", Nothing)

witness :: Hold -> Witness
witness h =
  Witness
    { hears = \ms -> atomically (modifyTVar' (picture h) (\p -> foldl (flip sensed) p ms)),
      wants = \a -> do
        t <- sinceBegan h
        atomically (modifyTVar' (picture h) (told a))
        case a of
          SayText s -> tellLine h (saidLine t s)
          PlaySound s -> tellLine h (soundLine t s)
          _ -> pure (),
      fires = atomically . modifyTVar' (picture h) . firedBy,
      noticed = tellLine h . linkLine
    }

-- | Fifty pictures a second, as many as the robot senses.
painting :: Hold -> IO ()
painting h = forever (threadDelay 20000 >> showFrame h)

showFrame :: Hold -> IO ()
showFrame h = do
  t <- sinceBegan h
  l <- atomically $ do
    here' <- readTVar (guarded h)
    stateTVar (picture h) (frameLine t (isEvading here'))
  tellLine h l

-- | Lets the wheels turn while somebody watches, and repeats an emergency stop for a second.
watchingOver :: Hold -> Base -> IO ()
watchingOver h base = forever $ do
  threadDelay 50000
  t <- getMonotonicTime
  seen <- readTVarIO (aliveAt h)
  runs <- readTVarIO (running h)
  forM_ runs $ \_ -> do
    atomically (stateTVar (guarded h) (watching (t - seen < unwatched))) >>= mapM_ (tell base)
    when (t - seen > deserted) (stopRun h >> standing h base)
  stopped <- readTVarIO (stoppedAt h)
  forM_ stopped $ \since -> when (t - since < 1) (standing h base)
