{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.Guardian
-- Description : Guardian process of a connection to a base.
--
-- In: an open serial line or socket, the bytes of a stop, and heartbeats. Out: a stop on the line after 'heartbeatTimeout' without a heartbeat, which
-- is repeated until the next one, and a stop when this process has ended. So a process that is killed or suspended
-- (SIGKILL, SIGSTOP) leaves no base driving. The process itself is C (@cbits/rosy_guardian.c@), because it is forked from a process
-- with threads.
module Rosy.Robots.Guardian
  ( Guardian,
    withGuardian,
    sendHeartbeat,
    Heartbeats,
    newHeartbeats,
    lastHeartbeat,
    guardingSocket,
    heartbeatTimeout,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (race)
import Control.Exception (bracket)
import Control.Monad (unless)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Unsafe as B
import Data.IORef
import Data.Word (Word8)
import Foreign.C.Error (throwErrnoIfMinus1)
import Foreign.C.Types (CInt (..))
import Foreign.Marshal.Alloc (alloca)
import Foreign.Ptr (Ptr, castPtr)
import Foreign.Storable (peek)
import Network.Socket (Socket, unsafeFdSocket)
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Sentence
import System.Posix.Types (Fd (..))

-- | Its process number, and the descriptor that takes heartbeats.
data Guardian = Guardian CInt CInt

-- | Milliseconds without a heartbeat after which it sends a stop: kobuki_node's cmd_vel_timeout.
heartbeatTimeout :: Int
heartbeatTimeout = 600

-- | A guardian of this line, which sends these bytes; on a serial line it sends them too when the action is over. Heartbeats are expected at once.
withGuardian :: Fd -> ByteString -> (Guardian -> IO a) -> IO a
withGuardian (Fd line) stop = bracket start end
  where
    start = B.unsafeUseAsCStringLen stop $ \(bytes, size) -> alloca $ \heartbeat -> do
      pid <- throwErrnoIfMinus1 "guardian" (c_start line (castPtr bytes) (fromIntegral size) (fromIntegral heartbeatTimeout) heartbeat)
      Guardian pid <$> peek heartbeat
    end (Guardian pid heartbeat) = c_end pid heartbeat

-- | Whether the guardian is still there to receive it.
sendHeartbeat :: Guardian -> IO Bool
sendHeartbeat (Guardian _ heartbeat) = (== 0) <$> c_beat heartbeat

-- | When the guardians of a robot's sockets last had a heartbeat, seconds of 'bootSeconds'.
newtype Heartbeats = Heartbeats (IORef Double)

-- | There was none yet.
newHeartbeats :: IO Heartbeats
newHeartbeats = Heartbeats <$> newIORef 0

lastHeartbeat :: Heartbeats -> IO Double
lastHeartbeat (Heartbeats at) = readIORef at

-- | An action with a guardian of its socket, which has a heartbeat from here. An error when the guardian ends before the action: nothing drives without one.
guardingSocket :: Heartbeats -> Socket -> ByteString -> IO a -> IO a
guardingSocket (Heartbeats at) socket stop act = do
  fd <- unsafeFdSocket socket
  bootSeconds >>= writeIORef at
  withGuardian (Fd fd) stop $ \guardian -> either id id <$> race act (beats guardian)
  where
    beats guardian = do
      -- Before the heartbeat: this process may be suspended in between.
      t <- bootSeconds
      isThere <- sendHeartbeat guardian
      writeIORef at t
      unless isThere (ioError (userError (portable (tr "its guardian process has ended"))))
      threadDelay heartbeatPause
      beats guardian

-- | Microseconds between two heartbeats of a socket's guardian.
heartbeatPause :: Int
heartbeatPause = 50000

foreign import ccall safe "rosy_guardian_start" c_start :: CInt -> Ptr Word8 -> CInt -> CInt -> Ptr CInt -> IO CInt

foreign import ccall unsafe "rosy_guardian_beat" c_beat :: CInt -> IO CInt

foreign import ccall safe "rosy_guardian_end" c_end :: CInt -> CInt -> IO ()
