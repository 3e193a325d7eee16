{-# LANGUAGE CApiFFI #-}
{-# LANGUAGE InterruptibleFFI #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Ros.Net.Rpc
-- Description : Calls over sockets: one out, many in.
--
-- In: a call and where to send it; or a function that answers calls. Out: the answer or what went
-- wrong; or a server on a port of the system's choice. Every call has its own connection and a time
-- limit. This module does not know what the calls mean.
module Ros.Net.Rpc
  ( -- * Asking
    Uri (..),
    readUri,
    showUri,
    call,
    RpcError (..),
    explainRpcError,

    -- * Answering
    listenAnywhere,
    serveCalls,

    -- * Sockets
    connectTo,
    accepting,
    receiver,
    sendAtOnce,
  )
where

import Control.Applicative ((<|>))
import Control.Concurrent (ThreadId, forkIOWithUnmask, killThread, myThreadId, rtsSupportsBoundThreads, threadWaitRead)
import Control.Concurrent.MVar (modifyMVar_, newMVar, readMVar)
import Control.Exception (bracket, bracketOnError, finally, mask_, onException, try)
import Control.Monad (forever, void, when)
import Data.Bits ((.|.))
import qualified Data.ByteString as B
import qualified Data.ByteString.Unsafe as B
import Data.Char (isDigit, isSpace)
import Data.IORef (newIORef, readIORef, writeIORef)
import Data.List (stripPrefix)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Foreign.C.String (CString)
import Foreign.C.Types (CInt (..), CShort (..), CSize (..), CULong (..))
import Foreign.Marshal.Alloc (allocaBytes)
import Foreign.Ptr (Ptr)
import Foreign.Storable (pokeByteOff)
import GHC.IO.Exception (IOException (ioe_description))
import Network.Socket
import Network.Socket.ByteString (recv)
import Network.Socket.ByteString.Lazy (sendAll)
import Ros.Net.HostLookup (addressesOf)
import Ros.Net.Http
import Ros.Net.XmlRpc
import System.Posix.Types (CSsize (..), Fd (..))
import System.Timeout (timeout)

-- | @http://host:port/@
data Uri = Uri {uriHost :: String, uriPort :: Int}
  deriving (Eq, Ord, Show)

-- | Also without the @http@, and without a port: then it is the master's, 11311.
readUri :: String -> Maybe Uri
readUri t = case break (== ':') rest of
  (host@(_ : _), ':' : digits) | d@(_ : _) <- takeWhile isDigit digits, length d < 6, read d < (65536 :: Int) -> Just (Uri host (read d))
  (host@(_ : _), "") -> Just (Uri (takeWhile (/= '/') host) 11311)
  _ -> Nothing
  where
    trimmed = filter (not . isSpace) t
    rest = fromMaybe trimmed (stripPrefix "http://" trimmed <|> stripPrefix "rosrpc://" trimmed)

showUri :: Uri -> String
showUri (Uri h p) = "http://" ++ h ++ ":" ++ show p ++ "/"

data RpcError
  = -- | No answer from that address.
    Unreachable Uri String
  | -- | It took too long.
    Slow Uri
  | -- | What came back is not XML-RPC.
    Garbled Uri String
  | -- | The other side says it failed.
    Refused String
  deriving (Eq, Show)

explainRpcError :: RpcError -> String
explainRpcError e = case e of
  Unreachable u why -> "nothing answers at " ++ showUri u ++ " (" ++ why ++ ")"
  Slow u -> showUri u ++ " did not answer in time"
  Garbled u why -> showUri u ++ " answered with something else than XML-RPC (" ++ why ++ ")"
  Refused why -> why

-- | A call must be answered within 5 s: peers answer in a millisecond, and a node must notice a dead one.
limit :: Int
limit = 5000000

call :: Uri -> Call -> IO (Either RpcError Value)
call uri c = do
  done <- timeout limit (try (bracket (connectTo (uriHost uri) (uriPort uri)) close exchange))
  pure $ case done of
    Nothing -> Left (Slow uri)
    Just (Left e) -> Left (Unreachable uri (ioe_description e))
    Just (Right r) -> r
  where
    exchange s = do
      sendAll s (post (uriHost uri ++ ":" ++ show (uriPort uri)) "/RPC2" (encodeCall c))
      readAnswer s B.empty
    readAnswer s seen = do
      more <- recv s 65536
      let bytes = seen <> more
      case parseMessage bytes of
        Whole _ body _ -> pure (understand body)
        Bad why -> pure (Left (Garbled uri why))
        More _
          | not (B.null more) -> readAnswer s bytes
          | Just (_, body) <- bodyAtEnd bytes -> pure (understand body)
          | otherwise -> pure (Left (Garbled uri "the connection ended early"))
    understand body = case decodeAnswer body of
      Right (Answer v) -> Right v
      Right (Fault why) -> Left (Refused why)
      Left (NotXmlRpc wanted got) -> Left (Garbled uri ("expected " ++ wanted ++ ", got " ++ got))

-- | TCP to a host by name or number, without delay for small packets.
connectTo :: String -> Int -> IO Socket
connectTo host port = do
  addresses <- addressesOf defaultHints {addrSocketType = Stream} host port
  attempt addresses
  where
    attempt [] = ioError (userError "no address")
    attempt [a] = open a
    attempt (a : as) = try (open a) >>= either (\(_ :: IOException) -> attempt as) pure
    open a = bracketOnError (socket (addrFamily a) Stream defaultProtocol) close $ \s -> do
      setSocketOption s NoDelay 1
      connect s (addrAddress a)
      pure s

-- | Reads what has come; nothing at the end of the connection. The buffer begins small and grows while it
-- is filled: with 64 kB for every two-byte message, half of a node's time would go to collecting them.
receiver :: Socket -> IO (IO B.ByteString)
receiver s = do
  size <- newIORef 4096
  pure $ do
    n <- readIORef size
    waitReadable s
    b <- recv s n
    when (B.length b == n && n < 262144) (writeIORef size (n * 2))
    pure b

-- | Waits in the system, on a thread of its own, and not with the runtime's event manager: what arrives is then handled by the
-- thread that the system wakes, two calls of the system and not eight before the answer is on its way.
waitReadable :: Socket -> IO ()
waitReadable s
  | rtsSupportsBoundThreads = withFdSocket s $ \fd -> allocaBytes pollSize $ \entry -> do
    pokeByteOff entry fdOffset fd
    pokeByteOff entry eventsOffset pollIn
    let again = poll entry 1 lookUp >>= \n -> when (n <= 0) again
    again
  | otherwise = withFdSocket s (threadWaitRead . Fd)

-- | After so many milliseconds a wait begins anew: one that was to end just as it began has not noticed.
lookUp :: CInt
lookUp = 200

-- | @struct pollfd@ (poll.h): a descriptor, what is wished for, what happened.
pollSize, fdOffset, eventsOffset :: Int
pollSize = 8
fdOffset = 0
eventsOffset = 4

foreign import ccall interruptible "poll" poll :: Ptr () -> CULong -> CInt -> IO CInt

foreign import capi "poll.h value POLLIN" pollIn :: CShort

-- | How many of the bytes the system takes without waiting. None also when the connection is lost: who sends on it
-- and waits is told.
sendAtOnce :: Socket -> B.ByteString -> IO Int
sendAtOnce s bytes = withFdSocket s $ \fd ->
  B.unsafeUseAsCStringLen bytes $ \(p, n) -> max 0 . fromIntegral <$> send fd p (fromIntegral n) (dontWait .|. noSignal)

foreign import ccall unsafe "send" send :: CInt -> CString -> CSize -> CInt -> IO CSsize

foreign import capi "sys/socket.h value MSG_DONTWAIT" dontWait :: CInt

foreign import capi "sys/socket.h value MSG_NOSIGNAL" noSignal :: CInt

-- | A listening socket on a port of the system's choice; on loopback alone when others are not meant to
-- reach this node.
listenAnywhere :: Bool -> IO (Socket, Int)
listenAnywhere onlyHere = bracketOnError (socket AF_INET Stream defaultProtocol) close $ \s -> do
  bind s (SockAddrInet 0 (if onlyHere then tupleToHostAddress (127, 0, 0, 1) else 0))
  listen s 128
  port <- socketPort s
  pure (s, fromIntegral port)

-- | Accepts for ever, a thread per connection. When it ends, however it ends, so do they.
accepting :: Socket -> (Socket -> IO ()) -> IO ()
accepting listener serve = do
  open <- newMVar (Map.empty :: Map.Map ThreadId ())
  let child :: Socket -> (forall b. IO b -> IO b) -> IO ()
      child s unmask = do
        me <- myThreadId
        modifyMVar_ open (pure . Map.insert me ())
        void (try (unmask (setSocketOption s NoDelay 1 >> serve s)) :: IO (Either IOException ()))
          `finally` (close s >> modifyMVar_ open (pure . Map.delete me))
  forever (mask_ (accept listener >>= \(s, _) -> forkIOWithUnmask (child s) `onException` close s))
    `finally` (readMVar open >>= mapM_ killThread . Map.keys)

-- | The most that a caller may say, bytes. Calls to a node are lists of topics and addresses; a megabyte is a parameter of the largest robots.
maxCall :: Int
maxCall = 1024 * 1024

-- | Answers calls until it is cancelled.
serveCalls :: Socket -> (Call -> IO Answer) -> IO ()
serveCalls listener answer = accepting listener (`loop` B.empty)
  where
    loop s seen = case parseMessage seen of
      Whole top body behind -> do
        reply <- either (\(NotXmlRpc wanted _) -> pure (Fault ("expected " ++ wanted))) answer (decodeCall body)
        sendAll s (ok (keepsAlive top) (encodeAnswer reply))
        when (keepsAlive top) (loop s behind)
      Bad _ -> sendAll s refusal
      More _ | B.length seen > maxCall -> sendAll s refusal
      More top -> do
        when (maybe False wantsContinue top && B.length seen < maxHead) (sendAll s "HTTP/1.1 100 Continue\r\n\r\n")
        more <- recv s 65536
        if B.null more then pure () else loop s (seen <> more)
