{-# LANGUAGE CPP #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Link.Serial
-- Description : A base on its USB cable.
--
-- In: a device. Out: a 'Connection' while an action runs. A thread reads packets and answers each with the wanted speed, as
-- the base's own driver does; it opens the device again when the cable was pulled. A valid packet must
-- arrive first. The base is connected when it has said that its firmware is one that is known here; before that it is sent zero. A base with
-- other firmware is refused for good. It is lost after 0.3 s without a valid packet, whatever noise arrives meanwhile.
--
-- A speed that is not renewed in time becomes zero here ("Rosy.Robots.Expiry"), as in kobuki_node (cmd_vel_timeout), so a program that
-- hangs stops the robot. For a process that is killed or suspended, a guardian process ("Rosy.Robots.Guardian") sends the
-- stop: whether the base's firmware would stop on its own is documented nowhere.
module Rosy.Link.Serial
  ( withSerial,
  )
where

import Control.Concurrent (threadDelay, threadWaitRead, threadWaitWrite)
import Control.Concurrent.Async (race, withAsync)
import Control.Concurrent.STM
import Control.Exception (bracket, finally, try)
import Control.Monad (forM_, forever, unless, when)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Internal as B (createAndTrim)
import qualified Data.ByteString.Unsafe as B
import Data.IORef
import Data.Maybe (isNothing)
import qualified Data.Text as T
import Foreign.Ptr (castPtr)
import Ros.SlicedTimeout (timeoutInSlices)
import Rosy.Channel (Action)
import Rosy.Codec (commandRoutes, routeTopic)
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Kobuki.Command
import Rosy.Kobuki.Feedback
import qualified Rosy.Kobuki.Frame as Frame
import Rosy.Kobuki.Sensing
import Rosy.Robot
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.Connection
import Rosy.Robots.ConnectionError (explainConnectionError)
import Rosy.Robots.Expiry
import Rosy.Robots.Guardian
import Rosy.Robots.SerialCodec (readParts)
import Rosy.Sentence
import Rosy.Wire (pipeRoutes)
import System.Posix.IO (OpenFileFlags (..), OpenMode (..), closeFd, defaultFileFlags, fdReadBuf, fdWriteBuf, openFd)
import System.Posix.Terminal
import System.Posix.Types (Fd)

-- | Commands for the thread that writes.
data Setpoints = Setpoints
  { wantedVelocity :: TVar (Expiring Action),
    wantedOutputs :: TVar Outputs,
    -- | without power zero velocity is sent
    motorPower :: TVar MotorPower,
    -- | packets of commands that do not last, oldest first
    wantedPackets :: TQueue ByteString,
    -- | whether a packet arrived lately
    alive :: TVar Bool,
    -- | whether all commands have been written
    written :: TVar Bool
  }

withSerial :: FilePath -> (Connection -> IO a) -> IO a
withSerial device use = do
  hearing <- newEventQueue
  setpoints <- Setpoints <$> newTVarIO standing <*> newTVarIO powerOn <*> newTVarIO MotorsOn <*> newTQueueIO <*> newTVarIO False <*> newTVarIO True
  let connection =
        Connection
          { connectionName = trWith "the robot at {address}" ["address" =: T.pack device],
            connectionRoutes = pipeRoutes,
            registerTopics = \topics -> pure [trWith "A robot on a serial cable has no topic {topic}." ["topic" =: T.pack (topicName t)] | t <- topics, topicUse t == Taken || T.pack (topicName t) `notElem` map routeTopic (commandRoutes pipeRoutes)],
            sendCommand = \decided a -> atomically (updateSetpoints setpoints decided a),
            cancelGoals = pure (),
            refuseCall = \_ _ -> pure (),
            takeEvents = awaitEvents hearing,
            unreadableMessages = unreadableSoFar hearing,
            velocityTopic = pure Nothing
          }
      flush = timeoutInSlices flushTimeout (atomically ((,) <$> readTVar (alive setpoints) <*> readTVar (written setpoints) >>= \(a, w) -> check (not a || w)))
  withAsync (keepOpen device setpoints hearing) (\_ -> use connection `finally` flush)

-- | No movement.
standing :: Expiring Action
standing = lasting (VelocityCommand (Velocity 0 0))

updateSetpoints :: Setpoints -> Double -> Action -> STM ()
updateSetpoints setpoints decided a = do
  case a of
    VelocityCommand _ -> writeTVar (wantedVelocity setpoints) (expiring decided a)
    -- As kobuki_node does: velocities before power is back do not count.
    MotorPowerCommand p -> writeTVar (motorPower setpoints) p >> writeTVar (wantedVelocity setpoints) standing
    _ -> modifyTVar' (wantedOutputs setpoints) (obeying a) >> mapM_ (writeTQueue (wantedPackets setpoints)) (ownPacket a)
  writeTVar (written setpoints) False

-- | Half a second, in microseconds.
flushTimeout :: Int
flushTimeout = 500000

-- | Why packets are exchanged no longer.
data ExchangeEnd
  = -- | The device may be opened again.
    Interrupted Sentence
  | -- | The base is never driven.
    Unsupported Sentence

-- | Opens the device whenever it is there, until its base is refused.
keepOpen :: FilePath -> Setpoints -> EventQueue -> IO ()
keepOpen device setpoints hearing = newIORef unsensed >>= \sensing -> go sensing unknownReason
  where
    go sensing said = do
      modifyIORef' sensing resumed
      outcome <- try (bracket (openRaw device) closeFd (\fd -> withGuardian fd (baseControl 0 0) (exchangePackets fd setpoints hearing sensing)))
      was <- atomically (swapTVar (alive setpoints) False)
      case either (Interrupted . explainConnectionError) id outcome of
        -- Said again and again, because one program may run after another.
        Unsupported why -> forever (atomically (enqueue hearing (Refused why)) >> threadDelay reopenPause)
        Interrupted why -> do
          when (was || why /= said) (atomically (enqueue hearing (Disconnected why)))
          threadDelay reopenPause
          go sensing why

-- | Pause between attempts to open the device, microseconds. Upstream's driver waits 5 s.
reopenPause :: Int
reopenPause = 1000000

-- | Opens a device for reading and writing. The type of openFd differs between versions of unix.
openDevice :: FilePath -> OpenFileFlags -> IO Fd
#if MIN_VERSION_unix(2,8,0)
openDevice device = openFd device ReadWrite
#else
openDevice device = openFd device ReadWrite Nothing
#endif

-- | Raw bytes at 115200 baud, eight bits, no parity, one stop bit, no flow control.
openRaw :: FilePath -> IO Fd
openRaw device = do
  fd <- openDevice device defaultFileFlags {noctty = True, nonBlock = True}
  isTerminal <- queryTerminal fd
  unless isTerminal (closeFd fd >> ioError (userError (portable (tr "it is no serial line"))))
  now <- getTerminalAttributes fd
  let raw = foldl withoutMode now [InterruptOnBreak, MapCRtoLF, IgnoreCR, MapLFtoCR, StripHighBit, StartStopOutput, StartStopInput, CheckParity, ProcessOutput, EnableEcho, EchoErase, EchoKill, EchoLF, ProcessInput, KeyboardInterrupts, ExtendedFunctions, EnableParity, TwoStopBits, HangupOnClose]
      full = (raw `withMode` ReadEnable `withMode` LocalMode `withBits` 8 `withInputSpeed` B115200 `withOutputSpeed` B115200) `withMinInput` 1 `withTime` 0
  setTerminalAttributes fd full Immediately
  discardData fd InputQueue -- what was said before we listened is old
  pure fd

-- | Reads and answers packets until the cable is pulled, the guardian has ended, or the base is refused.
exchangePackets :: Fd -> Setpoints -> EventQueue -> IORef Sensing -> Guardian -> IO ExchangeEnd
exchangePackets fd setpoints hearing sensing guardian = do
  frames <- newIORef Frame.noBytes
  sentOutputs <- newIORef Nothing
  identified <- newIORef False
  firmware <- newIORef Nothing
  guarded <- newIORef True
  heartbeatAt <- bootSeconds >>= newIORef
  packetCount <- newTVarIO (0 :: Int)
  let go = do
        b <- readSome fd
        if B.null b
          then pure (Interrupted (tr "the cable was pulled"))
          else do
            Frame.Feeding found _ rest <- (`Frame.feed` b) <$> readIORef frames
            writeIORef frames rest
            mapM_ (packet' . readParts) found
            version <- readIORef firmware
            isGuarded <- readIORef guarded
            case version of
              Just v | not (isSupported v) -> pure (Unsupported (trWith "its firmware {version} speaks another protocol" ["version" =: T.pack (showVersion v)]))
              -- Nothing may drive without a guardian: the stop goes out before the line is closed.
              _ | not isGuarded -> Interrupted (tr "its guardian process has ended") <$ writeAll fd (baseControl 0 0)
              _ -> go
      packet' parts = do
        let feedback = readFeedback parts
        -- The first supported version stands: a corrupted packet whose checksum holds must not refuse a base that is driven.
        forM_ (firmwareVersion feedback) $ \v -> modifyIORef' firmware (\before -> if maybe False isSupported before then before else Just v)
        when (or [True | Udid {} <- feedback]) (writeIORef identified True)
        supported <- maybe False isSupported <$> readIORef firmware
        n <- atomically (stateTVar packetCount (\n -> (n, n + 1)))
        -- Once, for a base that is asked and does not answer.
        when (n == unansweredQuestions && not supported) (atomically (enqueue hearing (Disconnected (tr "it does not say which firmware it has, and is not driven before"))))
        when supported . forM_ (coreOf feedback) $ \_ -> do
          (messages, after) <- sense parts <$> readIORef sensing
          writeIORef sensing after
          atomically $ do
            was <- swapTVar (alive setpoints) True
            unless was (enqueue hearing Connected >> enqueue hearing (Received (RobotStatusMessage Online)))
            mapM_ (enqueue hearing . Received) messages
        reply supported
        -- Before the heartbeat: this process may be suspended in between.
        beating <- bootSeconds
        sendHeartbeat guardian >>= writeIORef guarded
        writeIORef heartbeatAt beating
      -- One write per packet, as the driver does.
      reply supported = do
        -- What the line does not take yet may expire meanwhile.
        threadWaitWrite fd
        heartbeat <- readIORef heartbeatAt
        t <- bootSeconds
        known <- readIORef identified
        lastOutputs <- readIORef sentOutputs
        (bytes, before, o) <- atomically $ do
          velocity <- readTVar (wantedVelocity setpoints)
          power <- readTVar (motorPower setpoints)
          let control = case valueAt heartbeat t velocity of
                VelocityCommand (Velocity v w) | supported && power == MotorsOn -> baseControl v w
                _ -> baseControl 0 0
          o <- readTVar (wantedOutputs setpoints)
          packets <- flushTQueue (wantedPackets setpoints)
          pure
            ( B.concat $
                [control]
                  ++ [outputs o | lastOutputs /= Just o]
                  ++ packets
                  ++ [requestVersions | not known],
              velocity,
              o
            )
        writeAll fd bytes
        writeIORef sentOutputs (Just o)
        atomically $ do
          now <- readTVar (wantedVelocity setpoints)
          later <- readTVar (wantedOutputs setpoints)
          none <- isEmptyTQueue (wantedPackets setpoints)
          when (now == before && later == o && none) (writeTVar (written setpoints) True)
  either id id <$> race go (watchPackets setpoints hearing packetCount)
  where
    isSupported (Version major _ _) = major == 1
    showVersion (Version a b c) = show a ++ "." ++ show b ++ "." ++ show c

-- | Reports a base as silent. Counts valid packets: noise is no sign of life.
watchPackets :: Setpoints -> EventQueue -> TVar Int -> IO a
watchPackets setpoints hearing packetCount = forever $ do
  before <- readTVarIO packetCount
  came <- timeoutInSlices silenceTimeout (atomically (readTVar packetCount >>= check . (/= before)))
  when (isNothing came) . atomically $ do
    now <- readTVar packetCount
    was <- readTVar (alive setpoints)
    when (was && now == before) (writeTVar (alive setpoints) False >> enqueue hearing (Disconnected (tr "it has fallen silent")))

-- | Packets after which a base that has not said its version is reported: each is answered with the question, two seconds.
unansweredQuestions :: Int
unansweredQuestions = 100

-- | What has come; nothing at the end of the line.
readSome :: Fd -> IO ByteString
readSome fd = threadWaitRead fd >> B.createAndTrim 4096 (\p -> fromIntegral <$> fdReadBuf fd p 4096)

-- | The base counts as silent after so long without a valid packet, microseconds: fifteen packets, half of the time after which
-- it stops by itself. Upstream's driver says 0.1 s (kobuki.cpp: isAlive); a busy laptop oversleeps that.
silenceTimeout :: Int
silenceTimeout = 300000

writeAll :: Fd -> ByteString -> IO ()
writeAll fd bytes = unless (B.null bytes) $ do
  threadWaitWrite fd
  n <- B.unsafeUseAsCStringLen bytes (\(p, len) -> fdWriteBuf fd (castPtr p) (fromIntegral len))
  writeAll fd (B.drop (fromIntegral n) bytes)
