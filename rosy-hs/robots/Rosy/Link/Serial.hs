{-# LANGUAGE CPP #-}

-- |
-- Module      : Rosy.Link.Serial
-- Description : A base on its USB cable.
--
-- In: a device. Out: a 'Connection' while an action runs. A thread reads packets and answers each with the wanted speed, as
-- the base's own driver does; it opens the device again when the cable was pulled. A valid packet must
-- arrive first, and nothing is sent to a base without packets for 0.3 s.
--
-- A speed that is not renewed within 0.6 s becomes zero here, as in kobuki_node (cmd_vel_timeout), so a program that
-- hangs stops the robot. For a program that is killed, a watchdog process (a shell) waits for its end and then sends the
-- stop: whether the base's firmware would stop on its own is documented nowhere.
module Rosy.Link.Serial
  ( withSerial,
    startWatchdog,
  )
where

import Control.Concurrent (threadDelay, threadWaitRead, threadWaitWrite)
import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM
import Control.Exception (bracket, finally, try)
import Control.Monad (forM_, unless, void, when)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Internal as B (createAndTrim)
import qualified Data.ByteString.Unsafe as B
import Data.IORef
import qualified Data.Text as T
import Foreign.Ptr (castPtr)
import GHC.Clock (getMonotonicTime)
import Numeric (showOct)
import Ros.SlicedTimeout (timeoutInSlices)
import Rosy.Channel (Action)
import Rosy.Codec (commandRoutes, routeTopic)
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Kobuki.Command
import Rosy.Kobuki.Feedback
import qualified Rosy.Kobuki.Frame as Frame
import Rosy.Kobuki.Sensing
import Rosy.Robot
import Rosy.Robots.Connection
import Rosy.Robots.ConnectionError (explainConnectionError)
import Rosy.Robots.SerialCodec (readParts)
import Rosy.Wire (pipeRoutes)
import System.IO (Handle, hClose)
import System.Posix.IO (OpenFileFlags (..), OpenMode (..), closeFd, defaultFileFlags, fdReadBuf, fdWriteBuf, openFd)
import System.Posix.Terminal
import System.Posix.Types (Fd)
import System.Process (CreateProcess (..), ProcessHandle, StdStream (..), createProcess, proc, waitForProcess)

-- | Commands for the thread that writes.
data Setpoints = Setpoints
  { -- | m/s, rad/s, and the time of the command, monotonic seconds
    wantedVelocity :: TVar (Double, Double, Double),
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
  setpoints <- Setpoints <$> newTVarIO (0, 0, 0) <*> newTVarIO powerOn <*> newTVarIO MotorsOn <*> newTQueueIO <*> newTVarIO False <*> newTVarIO True
  let connection =
        Connection
          { connectionName = "the robot at " ++ device,
            connectionRoutes = pipeRoutes,
            registerTopics = \topics -> pure ["A robot on a serial cable has no topic " ++ topicName t ++ "." | t <- topics, topicUse t == Taken || T.pack (topicName t) `notElem` map routeTopic (commandRoutes pipeRoutes)],
            sendCommand = \a -> do
              t <- getMonotonicTime
              atomically (updateSetpoints setpoints t a),
            takeEvents = awaitEvents hearing
          }
      flush = timeoutInSlices flushTimeout (atomically ((,) <$> readTVar (alive setpoints) <*> readTVar (written setpoints) >>= \(a, w) -> check (not a || w)))
  withAsync (keepOpen device setpoints hearing) (\_ -> use connection `finally` flush)

updateSetpoints :: Setpoints -> Double -> Action -> STM ()
updateSetpoints setpoints t a = do
  case a of
    VelocityCommand (Velocity v w) -> writeTVar (wantedVelocity setpoints) (v, w, t)
    -- As kobuki_node does: velocities before power is back do not count.
    MotorPowerCommand p -> writeTVar (motorPower setpoints) p >> writeTVar (wantedVelocity setpoints) (0, 0, 0)
    _ -> modifyTVar' (wantedOutputs setpoints) (obeying a) >> mapM_ (writeTQueue (wantedPackets setpoints)) (ownPacket a)
  writeTVar (written setpoints) False

-- | Half a second, in microseconds.
flushTimeout :: Int
flushTimeout = 500000

-- | Opens the device whenever it is there.
keepOpen :: FilePath -> Setpoints -> EventQueue -> IO ()
keepOpen device setpoints hearing = newIORef unsensed >>= \sensing -> go sensing ""
  where
    go sensing said = do
      modifyIORef' sensing resumed
      outcome <- try (bracket (openRaw device) closeFd (\fd -> guarded (exchangePackets fd setpoints hearing sensing)))
      was <- atomically (swapTVar (alive setpoints) False)
      let why = either explainConnectionError id outcome
      when (was || why /= said) (atomically (enqueue hearing (Disconnected why)))
      threadDelay reopenPause
      go sensing why
    guarded act = bracket (startWatchdog device) stopWatchdog (const act)

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
  unless isTerminal (closeFd fd >> ioError (userError "it is no serial line"))
  now <- getTerminalAttributes fd
  let raw = foldl withoutMode now [InterruptOnBreak, MapCRtoLF, IgnoreCR, MapLFtoCR, StripHighBit, StartStopOutput, StartStopInput, CheckParity, ProcessOutput, EnableEcho, EchoErase, EchoKill, EchoLF, ProcessInput, KeyboardInterrupts, ExtendedFunctions, EnableParity, TwoStopBits, HangupOnClose]
      full = (raw `withMode` ReadEnable `withMode` LocalMode `withBits` 8 `withInputSpeed` B115200 `withOutputSpeed` B115200) `withMinInput` 1 `withTime` 0
  setTerminalAttributes fd full Immediately
  discardData fd InputQueue -- what was said before we listened is old
  pure fd

-- | Reads and answers packets until the cable is pulled.
exchangePackets :: Fd -> Setpoints -> EventQueue -> IORef Sensing -> IO String
exchangePackets fd setpoints hearing sensing = do
  frames <- newIORef Frame.noBytes
  sentOutputs <- newIORef Nothing
  identified <- newIORef False
  oldFirmware <- newIORef Nothing
  let go = do
        came <- readSome fd
        case came of
          Nothing -> silent >> go
          Just b | B.null b -> pure "the cable was pulled"
          Just b -> do
            Frame.Feeding found _ rest <- (`Frame.feed` b) <$> readIORef frames
            writeIORef frames rest
            mapM_ (packet' . readParts) found
            refused <- readIORef oldFirmware
            maybe go (\v -> pure ("its firmware " ++ showVersion v ++ " speaks another protocol")) refused
      silent = do
        was <- atomically (swapTVar (alive setpoints) False)
        when was (atomically (enqueue hearing (Disconnected "it has fallen silent") >> enqueue hearing (Received (RobotStatusMessage Offline))))
      packet' parts = do
        let feedback = readFeedback parts
        forM_ (firmwareVersion feedback) $ \v@(Version major _ _) -> when (major /= 1) (writeIORef oldFirmware (Just v))
        when (or [True | Udid {} <- feedback]) (writeIORef identified True)
        forM_ (coreOf feedback) $ \_ -> do
          (messages, after) <- sense parts <$> readIORef sensing
          writeIORef sensing after
          atomically $ do
            was <- swapTVar (alive setpoints) True
            unless was (enqueue hearing Connected >> enqueue hearing (Received (RobotStatusMessage Online)))
            mapM_ (enqueue hearing . Received) messages
        reply
      -- One write per packet, as the driver does.
      reply = do
        t <- getMonotonicTime
        known <- readIORef identified
        lastOutputs <- readIORef sentOutputs
        (bytes, before, o) <- atomically $ do
          velocity@(v, w, said) <- readTVar (wantedVelocity setpoints)
          power <- readTVar (motorPower setpoints)
          let drives = t - said <= commandTimeout && power == MotorsOn
          o <- readTVar (wantedOutputs setpoints)
          packets <- flushTQueue (wantedPackets setpoints)
          pure
            ( B.concat $
                [if drives then baseControl v w else baseControl 0 0]
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
  go
  where
    showVersion (Version a b c) = show a ++ "." ++ show b ++ "." ++ show c

-- | kobuki_node: cmd_vel_timeout, seconds.
commandTimeout :: Double
commandTimeout = 0.6

-- | What has come; nothing at the end of the line; none when nothing came for so long.
readSome :: Fd -> IO (Maybe ByteString)
readSome fd = timeoutInSlices silenceTimeout (threadWaitRead fd) >>= traverse (const (B.createAndTrim 4096 (\p -> fromIntegral <$> fdReadBuf fd p 4096)))

-- | The base counts as silent after so long without a packet, microseconds: fifteen packets, half of the time after which
-- it stops by itself. Upstream's driver says 0.1 s (kobuki.cpp: isAlive); a busy laptop oversleeps that.
silenceTimeout :: Int
silenceTimeout = 300000

writeAll :: Fd -> ByteString -> IO ()
writeAll fd bytes = unless (B.null bytes) $ do
  threadWaitWrite fd
  n <- B.unsafeUseAsCStringLen bytes (\(p, len) -> fdWriteBuf fd (castPtr p) (fromIntegral len))
  writeAll fd (B.drop (fromIntegral n) bytes)

-- | Starts the watchdog: a shell that holds the line open, waits until this program has closed its pipe or ended, and then
-- sends a stop.
startWatchdog :: FilePath -> IO (Handle, ProcessHandle)
startWatchdog device = do
  started <- createProcess (proc "/bin/sh" ["-c", script, "rosy-guardian", device]) {std_in = CreatePipe, close_fds = True}
  case started of
    (Just hold, _, _, p) -> pure (hold, p)
    _ -> ioError (userError "no pipe to the guardian")
  where
    script = "trap '' INT TERM HUP; exec 3>\"$1\"; cat >/dev/null; printf '" ++ concatMap octal (B.unpack (baseControl 0 0)) ++ "' >&3 2>/dev/null"
    octal b = '\\' : drop 1 (showOct (512 + fromIntegral b :: Int) "")

stopWatchdog :: (Handle, ProcessHandle) -> IO ()
stopWatchdog (hold, p) = hClose hold >> void (waitForProcess p)
