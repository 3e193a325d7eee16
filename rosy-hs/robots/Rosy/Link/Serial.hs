-- |
-- Module      : Rosy.Link.Serial
-- Description : A base on its USB cable.
--
-- In: a device. Out: a 'Base' while an action runs. A thread reads packets and answers each with the wanted speed, as
-- the base's own driver does; it opens the device again when the cable was pulled. The base must say a valid packet
-- first, and nothing is sent to one that has been silent for 0.3 s.
--
-- A speed that is not renewed within 0.6 s becomes zero here, as in kobuki_node (cmd_vel_timeout), so a program that
-- hangs stops the robot. For a program that is killed there is a shell that waits for its death and then sends the
-- stop itself: whether the base's firmware would stop on its own is documented nowhere.
module Rosy.Link.Serial
  ( withSerial,
    guardian,
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
import Foreign.Ptr (castPtr)
import GHC.Clock (getMonotonicTime)
import Numeric (showOct)
import Rosy.Core (Action (..), Message (..))
import Rosy.Kobuki.Command
import Rosy.Kobuki.Feedback
import qualified Rosy.Kobuki.Frame as Frame
import Rosy.Kobuki.Sensing
import Rosy.Robot
import Rosy.Robots.Base
import Rosy.Robots.Reason (reason)
import System.IO (Handle, hClose)
import System.Posix.IO (OpenFileFlags (..), OpenMode (..), closeFd, defaultFileFlags, fdReadBuf, fdWriteBuf, openFd)
import System.Posix.Terminal
import System.Posix.Types (Fd)
import System.Process (CreateProcess (..), ProcessHandle, StdStream (..), createProcess, proc, waitForProcess)
import System.Timeout (timeout)

-- | What the thread that writes knows.
data Wanted = Wanted
  { -- | m/s, rad/s, and when it was said
    wantedVelocity :: TVar (Double, Double, Double),
    wantedOutputs :: TVar Outputs,
    -- | sounds, oldest first
    wantedSounds :: TQueue Sound,
    -- | whether the base has said something lately
    alive :: TVar Bool,
    -- | all that was wanted has been written
    written :: TVar Bool
  }

withSerial :: FilePath -> (Base -> IO a) -> IO a
withSerial device use = do
  hearing <- newHearing
  wanted <- Wanted <$> newTVarIO (0, 0, 0) <*> newTVarIO powerOn <*> newTQueueIO <*> newTVarIO False <*> newTVarIO True
  let base =
        Base
          { baseName = "the robot at " ++ device,
            tell = \a -> do
              t <- getMonotonicTime
              atomically (want wanted t a),
            hear = hearAll hearing
          }
      flush = timeout farewell (atomically ((,) <$> readTVar (alive wanted) <*> readTVar (written wanted) >>= \(a, w) -> check (not a || w)))
  withAsync (keepOpen device wanted hearing) (\_ -> use base `finally` flush)

want :: Wanted -> Double -> Action -> STM ()
want wanted t a = do
  case a of
    SetVelocity v w -> writeTVar (wantedVelocity wanted) (v, w, t)
    SetLed1 c -> modifyTVar' (wantedOutputs wanted) (withLed1 c)
    SetLed2 c -> modifyTVar' (wantedOutputs wanted) (withLed2 c)
    PlaySound s -> writeTQueue (wantedSounds wanted) s
    SayText _ -> pure ()
  writeTVar (written wanted) False

-- | Half a second, in microseconds.
farewell :: Int
farewell = 500000

-- | Opens the device whenever it is there.
keepOpen :: FilePath -> Wanted -> Hearing -> IO ()
keepOpen device wanted hearing = newIORef unsensed >>= \sensing -> go sensing ""
  where
    go sensing said = do
      modifyIORef' sensing resumed
      outcome <- try (bracket (openRaw device) closeFd (\fd -> guarded (converse fd wanted hearing sensing)))
      was <- atomically (swapTVar (alive wanted) False)
      let why = either reason id outcome
      when (was || why /= said) (atomically (heard hearing (Gone why)))
      threadDelay again
      go sensing why
    guarded act = bracket (guardian device) dismiss (const act)

-- | Pause between attempts to open the device, microseconds. Upstream's driver waits 5 s.
again :: Int
again = 1000000

-- | Raw bytes at 115200 baud, eight bits, no parity, one stop bit, no flow control.
openRaw :: FilePath -> IO Fd
openRaw device = do
  fd <- openFd device ReadWrite Nothing defaultFileFlags {noctty = True, nonBlock = True}
  isTerminal <- queryTerminal fd
  unless isTerminal (closeFd fd >> ioError (userError "it is no serial line"))
  now <- getTerminalAttributes fd
  let raw = foldl withoutMode now [InterruptOnBreak, MapCRtoLF, IgnoreCR, MapLFtoCR, StripHighBit, StartStopOutput, StartStopInput, CheckParity, ProcessOutput, EnableEcho, EchoErase, EchoKill, EchoLF, ProcessInput, KeyboardInterrupts, ExtendedFunctions, EnableParity, TwoStopBits, HangupOnClose]
      full = (raw `withMode` ReadEnable `withMode` LocalMode `withBits` 8 `withInputSpeed` B115200 `withOutputSpeed` B115200) `withMinInput` 1 `withTime` 0
  setTerminalAttributes fd full Immediately
  discardData fd InputQueue -- what was said before we listened is old
  pure fd

-- | Packets in, packets out, until the cable is pulled.
converse :: Fd -> Wanted -> Hearing -> IORef Sensing -> IO String
converse fd wanted hearing sensing = do
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
            mapM_ (packet' . readFeedback) found
            refused <- readIORef oldFirmware
            maybe go (\v -> pure ("its firmware " ++ showVersion v ++ " speaks another protocol")) refused
      silent = do
        was <- atomically (swapTVar (alive wanted) False)
        when was (atomically (heard hearing (Gone "it has fallen silent") >> heard hearing (Heard (StatusMessage Offline))))
      packet' parts = do
        forM_ (firmwareVersion parts) $ \v@(Version major _ _) -> when (major /= 1) (writeIORef oldFirmware (Just v))
        when (or [True | Udid {} <- parts]) (writeIORef identified True)
        forM_ (coreOf parts) $ \core -> do
          (messages, after) <- sense core (inertiaOf parts) <$> readIORef sensing
          writeIORef sensing after
          atomically $ do
            was <- swapTVar (alive wanted) True
            unless was (heard hearing Here >> heard hearing (Heard (StatusMessage Online)))
            mapM_ (heard hearing . Heard) messages
        reply
      -- One write per packet, as the driver does.
      reply = do
        t <- getMonotonicTime
        known <- readIORef identified
        lastOutputs <- readIORef sentOutputs
        (bytes, before, o) <- atomically $ do
          velocity@(v, w, said) <- readTVar (wantedVelocity wanted)
          let fresh = t - said <= timeLimit
          o <- readTVar (wantedOutputs wanted)
          sounds <- flushTQueue (wantedSounds wanted)
          pure
            ( B.concat $
                [if fresh then baseControl v w else baseControl 0 0]
                  ++ [outputs o | lastOutputs /= Just o]
                  ++ map soundSequence sounds
                  ++ [requestVersions | not known],
              velocity,
              o
            )
        writeAll fd bytes
        writeIORef sentOutputs (Just o)
        atomically $ do
          now <- readTVar (wantedVelocity wanted)
          later <- readTVar (wantedOutputs wanted)
          none <- isEmptyTQueue (wantedSounds wanted)
          when (now == before && later == o && none) (writeTVar (written wanted) True)
  go
  where
    showVersion (Version a b c) = show a ++ "." ++ show b ++ "." ++ show c

-- | kobuki_node: cmd_vel_timeout, seconds.
timeLimit :: Double
timeLimit = 0.6

-- | What has come; nothing at the end of the line; none when nothing came for so long.
readSome :: Fd -> IO (Maybe ByteString)
readSome fd = patiently quiet (threadWaitRead fd) >>= traverse (const (B.createAndTrim 4096 (\p -> fromIntegral <$> fdReadBuf fd p 4096)))

-- | The base counts as silent after so long without a packet, microseconds: fifteen packets, half of the time after which
-- it stops by itself. Upstream's driver says 0.1 s (kobuki.cpp: isAlive); a busy laptop oversleeps that.
quiet :: Int
quiet = 300000

writeAll :: Fd -> ByteString -> IO ()
writeAll fd bytes = unless (B.null bytes) $ do
  threadWaitWrite fd
  n <- B.unsafeUseAsCStringLen bytes (\(p, len) -> fdWriteBuf fd (castPtr p) (fromIntegral len))
  writeAll fd (B.drop (fromIntegral n) bytes)

-- | A shell that holds the line open, waits until this program lets go of it, however that happens, and then
-- says stop.
guardian :: FilePath -> IO (Handle, ProcessHandle)
guardian device = do
  started <- createProcess (proc "/bin/sh" ["-c", script, "rosy-guardian", device]) {std_in = CreatePipe, close_fds = True}
  case started of
    (Just hold, _, _, p) -> pure (hold, p)
    _ -> ioError (userError "no pipe to the guardian")
  where
    script = "trap '' INT TERM HUP; exec 3>\"$1\"; cat >/dev/null; printf '" ++ concatMap octal (B.unpack (baseControl 0 0)) ++ "' >&3 2>/dev/null"
    octal b = '\\' : drop 1 (showOct (512 + fromIntegral b :: Int) "")

dismiss :: (Handle, ProcessHandle) -> IO ()
dismiss (hold, p) = hClose hold >> void (waitForProcess p)
