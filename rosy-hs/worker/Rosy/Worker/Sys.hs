{-# LANGUAGE ForeignFunctionInterface #-}

-- |
-- Module      : Rosy.Worker.Sys
-- Description : The system calls of cbits/rosy_sys.c, as Haskell sees them.
--
-- Sockets with descriptors, one poll over everything, shared pages, and what a child gives up. Failures of calls
-- that cannot fail on a working machine are exceptions.
module Rosy.Worker.Sys
  ( -- * Talking
    Received (..),
    receive,
    Sent (..),
    send,

    -- * Waiting
    watchChildren,
    drain,
    Wanted (..),
    poll,
    Ended (..),
    reap,

    -- * Sharing
    Page,
    newPage,
    freePage,
    pageBytes,
    keepPage,
    newPair,
    writeAll,
    readSome,

    -- * Becoming a child
    beginChild,
    beNice,
    beCalled,
    filterCompiling,
    filterRunning,
    limitData,
    limitProcess,
    limitHeap,
    limitCpu,
    dataSize,
    areaOf,
    clearArea,
    exitNow,
  )
where

import Control.Exception (throwIO)
import Control.Monad (void, when)
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import Data.ByteString.Internal (createAndTrim, createAndTrim')
import Data.ByteString.Unsafe (unsafeUseAsCStringLen)
import Data.Word (Word32, Word64, Word8)
import Foreign.C.Error (errnoToIOError, getErrno)
import Foreign.C.String (CString, withCString)
import Foreign.C.Types
import Foreign.Marshal.Alloc (alloca)
import Foreign.Marshal.Array (allocaArray, peekArray, withArrayLen)
import Foreign.Ptr (Ptr, castPtr, nullPtr)
import Foreign.Storable (peek)
import Rosy.Worker.Page (pageSize)
import System.Mem (performMinorGC)
import System.Posix.IO (fdReadBuf)
import System.Posix.Types (CSsize (..), Fd (..))

foreign import ccall unsafe rosy_receive :: CInt -> Ptr Word8 -> CSize -> Ptr CInt -> IO CSsize

foreign import ccall unsafe rosy_send :: CInt -> Ptr CChar -> CSize -> IO CSsize

foreign import ccall unsafe rosy_watch_children :: IO CInt

foreign import ccall unsafe rosy_drain :: CInt -> IO ()

foreign import ccall safe rosy_poll :: CInt -> Ptr CInt -> Ptr CShort -> Ptr CShort -> CInt -> IO CInt

foreign import ccall unsafe rosy_reap :: Ptr CInt -> Ptr CInt -> IO CInt

foreign import ccall unsafe rosy_page :: IO (Ptr Word32)

foreign import ccall unsafe rosy_page_free :: Ptr Word32 -> IO ()

foreign import ccall unsafe rosy_page_keep :: Ptr Word32 -> IO ()

foreign import ccall unsafe rosy_pair :: Ptr CInt -> IO CInt

foreign import ccall unsafe rosy_write_all :: CInt -> Ptr CChar -> CSize -> IO CInt

foreign import ccall unsafe rosy_name :: CString -> IO CInt

foreign import ccall unsafe rosy_nice :: CInt -> IO CInt

foreign import ccall unsafe rosy_child_begin :: CInt -> Ptr CInt -> CInt -> CInt -> CInt -> IO CInt

foreign import ccall unsafe rosy_filter_compiling :: IO CInt

foreign import ccall unsafe rosy_filter_running :: IO CInt

foreign import ccall unsafe rosy_limit_data :: Word64 -> IO CInt

foreign import ccall unsafe rosy_limit_process :: Word64 -> CInt -> IO CInt

foreign import ccall unsafe rosy_limit_cpu :: Word64 -> IO CInt

foreign import ccall unsafe rosy_limit_heap :: Word64 -> IO ()

foreign import ccall unsafe rosy_data_size :: IO Word64

foreign import ccall unsafe rosy_area :: Word64 -> IO ()

foreign import ccall unsafe rosy_area_clear :: IO ()

foreign import ccall unsafe rosy_exit :: CInt -> IO ()

orThrow :: String -> IO CInt -> IO CInt
orThrow what action = do
  result <- action
  when (result < 0) $ do
    errno <- getErrno
    throwIO (errnoToIOError what errno Nothing Nothing)
  pure result

-- | What a read gave. The descriptor is one that rode along.
data Received
  = Bytes ByteString (Maybe Fd)
  | NothingYet
  | Closed

receive :: Fd -> IO Received
receive (Fd fd) = alloca $ \riding -> do
  (bytes, got) <- createAndTrim' chunk $ \buffer -> do
    n <- rosy_receive fd buffer (fromIntegral chunk) riding
    pure (0, max 0 (fromIntegral n), n)
  rode <- peek riding
  let passenger = if got > 0 && rode >= 0 then Just (Fd rode) else Nothing
  pure $ case got of
    -2 -> NothingYet
    n | n <= 0 -> Closed
    _ -> Bytes bytes passenger
  where
    chunk = 65536

-- | How many bytes went out, or that the other end is gone.
data Sent = Sent Int | Gone

send :: Fd -> ByteString -> IO Sent
send (Fd fd) bytes = unsafeUseAsCStringLen bytes $ \(buffer, size) -> do
  put <- rosy_send fd buffer (fromIntegral size)
  pure $ case put of
    -2 -> Sent 0
    n | n < 0 -> Gone
    n -> Sent (fromIntegral n)

-- | A descriptor at which a byte arrives whenever a child has ended.
watchChildren :: IO Fd
watchChildren = Fd <$> orThrow "sigaction" rosy_watch_children

drain :: Fd -> IO ()
drain (Fd fd) = rosy_drain fd

data Wanted = ToRead | ToWriteOrRead
  deriving (Eq)

-- | Waits until a descriptor is ready, or so many milliseconds; the flags say which are (to read, to write).
poll :: [(Fd, Wanted)] -> Int -> IO [(Bool, Bool)]
poll wanted milliseconds =
  withArrayLen [fd | (Fd fd, _) <- wanted] $ \count fds ->
    withArrayLen (map (events . snd) wanted) $ \_ wants ->
      allocaArray (max 1 count) $ \got -> do
        _ <- rosy_poll (fromIntegral count) fds wants got (fromIntegral milliseconds)
        map (\e -> (readable e, writable e)) <$> peekArray count got
  where
    -- poll(2): POLLIN 1, POLLOUT 4, POLLERR 8, POLLHUP 16, POLLNVAL 32.
    events ToRead = 1
    events ToWriteOrRead = 5
    readable e = any (bit e) [1, 8, 16, 32]
    writable e = bit e 4
    bit :: CShort -> CShort -> Bool
    bit e b = (e `div` b) `mod` 2 == 1

data Ended = Exited Int | Signalled Int
  deriving (Eq, Show)

-- | One child that has ended.
reap :: IO (Maybe (Int, Ended))
reap = alloca $ \how -> alloca $ \value -> do
  pid <- rosy_reap how value
  if pid == 0
    then pure Nothing
    else do
      h <- peek how
      v <- fromIntegral <$> peek value
      pure (Just (fromIntegral pid, if h == 0 then Exited v else Signalled v))

-- | Memory that a forked child shares with its parent, 'pageSize' bytes.
type Page = Ptr Word32

newPage :: IO Page
newPage = do
  page <- rosy_page
  when (page == nullPtr) (void $ orThrow "mmap" (pure (-1)))
  pure page

freePage :: Page -> IO ()
freePage = rosy_page_free

-- | What stands in a page now.
pageBytes :: Page -> IO ByteString
pageBytes page = ByteString.packCStringLen (castPtr page, pageSize)

-- | Children that are forked from now on do not see the page.
keepPage :: Page -> IO ()
keepPage = rosy_page_keep

-- | Two sockets that are connected to each other.
newPair :: IO (Fd, Fd)
newPair = allocaArray 2 $ \ends -> do
  _ <- orThrow "socketpair" (rosy_pair ends)
  both <- peekArray 2 ends
  case both of
    [a, b] -> pure (Fd a, Fd b)
    _ -> error "newPair: two ends were asked for"

-- | Writes everything, waiting as long as it takes.
writeAll :: Fd -> ByteString -> IO ()
writeAll (Fd fd) bytes =
  void $ unsafeUseAsCStringLen bytes (\(buffer, size) -> orThrow "write" (rosy_write_all fd buffer (fromIntegral size)))

-- | What is there, waiting for it; nothing when the other end is closed.
readSome :: Fd -> IO ByteString
readSome fd = createAndTrim chunk (\buffer -> fromIntegral <$> fdReadBuf fd buffer (fromIntegral chunk))
  where
    chunk = 65536

-- | The name that the system shows for this process, at most 15 characters.
beCalled :: String -> IO ()
beCalled name = withCString name (void . rosy_name)

-- | See @rosy_child_begin@: the descriptors to keep, one that stands in for 0 to 2, whether files cannot be written, and whether
-- no rights can be gained.
beginChild :: [Fd] -> Fd -> Bool -> Bool -> IO ()
beginChild keep (Fd nullFd) noFiles noPrivileges =
  void $ withArrayLen [fd | Fd fd <- keep] (\n fds -> orThrow "becoming a child" (rosy_child_begin (fromIntegral n) fds nullFd (flag noFiles) (flag noPrivileges)))

flag :: Bool -> CInt
flag = fromIntegral . fromEnum

-- | Others go first. A refusal changes nothing that matters.
beNice :: Int -> IO ()
beNice n = void $ rosy_nice (fromIntegral n)

filterCompiling, filterRunning :: IO ()
filterCompiling = void $ orThrow "seccomp" rosy_filter_compiling
filterRunning = void $ orThrow "seccomp" rosy_filter_running

-- | Bytes of private memory; a later limit may be larger.
limitData :: Word64 -> IO ()
limitData bytes = void $ orThrow "setrlimit" (rosy_limit_data bytes)

-- | Bytes of private memory for good (0: no limit), and whether no processes and threads may be started.
limitProcess :: Word64 -> Bool -> IO ()
limitProcess bytes alone = void $ orThrow "setrlimit" (rosy_limit_process bytes (flag alone))

-- | Seconds of computing from now on.
limitCpu :: Word64 -> IO ()
limitCpu seconds = void $ orThrow "setrlimit" (rosy_limit_cpu seconds)

limitHeap :: Word64 -> IO ()
limitHeap = rosy_limit_heap

dataSize :: IO Word64
dataSize = rosy_data_size

-- | Bytes that may be allocated between two collections, from now on.
areaOf :: Word64 -> IO ()
areaOf bytes = rosy_area bytes >> performMinorGC

-- | Gives back what the area for new values does not hold at the moment: most of it, right after a collection.
clearArea :: IO ()
clearArea = rosy_area_clear

-- | Ends this process at once: no finalizers, no last collection, which would cost more than the whole run.
exitNow :: Int -> IO ()
exitNow = rosy_exit . fromIntegral
