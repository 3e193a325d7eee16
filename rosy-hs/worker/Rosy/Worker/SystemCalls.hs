{-# LANGUAGE ForeignFunctionInterface #-}

-- |
-- Module      : Rosy.Worker.SystemCalls
-- Description : Bindings to the system calls in cbits/rosy_sys.c.
--
-- Sockets that pass descriptors, poll, shared pages, and the restrictions of a child. A failure of a call that cannot fail on a working
-- machine is an exception.
module Rosy.Worker.SystemCalls
  ( -- * Sockets
    Link (..),
    closeLink,
    Received (..),
    receive,
    Sent (..),
    send,
    sendWithLink,

    -- * Waiting
    watchChildren,
    drain,
    Interest (..),
    poll,
    ProcessEnd (..),
    reapChild,
    processorTime,

    -- * Shared memory and channels
    SharedPage,
    newSharedPage,
    freeSharedPage,
    readSharedPage,
    unmapInChildren,
    newSocketPair,
    writeAll,
    readSome,

    -- * Restricting a child
    dropCapabilities,
    restrictChild,
    becomeWorker,
    mapCode,
    protectMemory,
    lowerPriority,
    setProcessName,
    filterCompiling,
    filterRunning,
    limitData,
    limitProcess,
    limitHeap,
    deferCollections,
    compactHeap,
    limitCpu,
    dataSegmentSize,
    anonymousMemory,
    machineMemory,
    setAllocationArea,
    setLargeAllocationArea,
    shrinkAllocationArea,
    keepYoung,
    releaseFreeMemory,
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
import Foreign.Storable (peek, peekElemOff)
import Rosy.Worker.SharedMemory (pageSize)
import System.Mem (performMajorGC, performMinorGC)
import System.Posix.IO (closeFd, fdReadBuf)
import System.Posix.Types (CSsize (..), Fd (..))

foreign import ccall unsafe rosy_receive :: CInt -> Ptr Word8 -> CSize -> Ptr CInt -> IO CSsize

foreign import ccall unsafe rosy_send :: CInt -> Ptr CChar -> CSize -> IO CSsize

foreign import ccall unsafe rosy_send_link :: CInt -> Ptr CChar -> CSize -> CInt -> Ptr CInt -> IO CInt

foreign import ccall unsafe rosy_watch_children :: IO CInt

foreign import ccall unsafe rosy_drain :: CInt -> IO ()

foreign import ccall safe rosy_poll :: CInt -> Ptr CInt -> Ptr CShort -> Ptr CShort -> CInt -> IO CInt

foreign import ccall unsafe rosy_reap :: Ptr CInt -> Ptr CInt -> IO CInt

foreign import ccall unsafe rosy_processor_time :: CInt -> IO CDouble

foreign import ccall unsafe rosy_page :: IO (Ptr Word32)

foreign import ccall unsafe rosy_page_free :: Ptr Word32 -> IO ()

foreign import ccall unsafe rosy_page_keep :: Ptr Word32 -> IO ()

foreign import ccall unsafe rosy_pair :: Ptr CInt -> IO CInt

foreign import ccall unsafe rosy_write_all :: CInt -> Ptr CChar -> CSize -> IO CInt

foreign import ccall unsafe rosy_map_code :: CInt -> IO ()

foreign import ccall unsafe rosy_name :: CString -> IO CInt

foreign import ccall unsafe rosy_nice :: CInt -> IO CInt

foreign import ccall unsafe rosy_drop_capabilities :: IO CInt

foreign import ccall unsafe rosy_fork_begin :: CInt -> Ptr CInt -> IO CInt

foreign import ccall unsafe rosy_child_begin :: CInt -> Ptr CInt -> CInt -> CInt -> CInt -> IO CInt

foreign import ccall unsafe rosy_protect_memory :: IO CInt

foreign import ccall unsafe rosy_filter_compiling :: IO CInt

foreign import ccall unsafe rosy_filter_running :: IO CInt

foreign import ccall unsafe rosy_limit_data :: Word64 -> IO CInt

foreign import ccall unsafe rosy_limit_process :: Word64 -> CInt -> IO CInt

foreign import ccall unsafe rosy_limit_cpu :: Word64 -> IO CInt

foreign import ccall unsafe rosy_limit_heap :: Word64 -> IO ()

foreign import ccall unsafe rosy_defer_collections :: Word64 -> Word64 -> IO ()

foreign import ccall unsafe rosy_compact_begin :: IO ()

foreign import ccall unsafe rosy_compact_end :: IO ()

foreign import ccall unsafe rosy_data_size :: IO Word64

foreign import ccall unsafe rosy_anonymous_memory :: CInt -> IO Word64

foreign import ccall unsafe rosy_machine_memory :: IO Word64

foreign import ccall unsafe rosy_area :: Word64 -> IO ()

foreign import ccall unsafe rosy_area_clear :: IO ()

foreign import ccall unsafe rosy_stay_young :: CInt -> IO ()

foreign import ccall unsafe rosy_free_clear :: IO ()

foreign import ccall unsafe rosy_fresh_begin :: Word64 -> IO ()

foreign import ccall unsafe rosy_fresh_end :: IO ()

foreign import ccall unsafe rosy_exit :: CInt -> IO ()

orThrow :: String -> IO CInt -> IO CInt
orThrow what action = do
  result <- action
  when (result < 0) $ do
    errno <- getErrno
    throwIO (errnoToIOError what errno Nothing Nothing)
  pure result

-- | The robot link of a program: its socket, and the memory of a mailbox if it has one.
data Link = Link {linkSocket :: Fd, linkMailbox :: Maybe Fd}
  deriving (Eq, Show)

closeLink :: Link -> IO ()
closeLink link = closeFd (linkSocket link) >> mapM_ closeFd (linkMailbox link)

-- | Result of a read, with the descriptors that were passed along.
data Received
  = Bytes ByteString (Maybe Link)
  | WouldBlock
  | Closed

receive :: Fd -> IO Received
receive (Fd fd) = allocaArray 2 $ \passed -> do
  (bytes, got) <- createAndTrim' chunk $ \buffer -> do
    n <- rosy_receive fd buffer (fromIntegral chunk) passed
    pure (0, max 0 (fromIntegral n), n)
  first <- peek passed
  second <- peekElemOff passed 1
  let descriptors = if got > 0 && first >= 0 then Just (Link (Fd first) (if second >= 0 then Just (Fd second) else Nothing)) else Nothing
  pure $ case got of
    -2 -> WouldBlock
    n | n <= 0 -> Closed
    _ -> Bytes bytes descriptors
  where
    chunk = 65536

-- | Number of bytes sent, or that the peer has closed.
data Sent = Sent Int | PeerClosed

send :: Fd -> ByteString -> IO Sent
send (Fd fd) bytes = unsafeUseAsCStringLen bytes $ \(buffer, size) -> do
  put <- rosy_send fd buffer (fromIntegral size)
  pure $ case put of
    -2 -> Sent 0
    n | n < 0 -> PeerClosed
    n -> Sent (fromIntegral n)

-- | Sends bytes with a copy of a link; whether all were sent. If not, the receiver must be given up.
sendWithLink :: Fd -> ByteString -> Link -> IO Bool
sendWithLink (Fd fd) bytes link = unsafeUseAsCStringLen bytes $ \(buffer, size) ->
  withArrayLen [one | Fd one <- linkSocket link : maybe [] pure (linkMailbox link)] $ \count passed ->
    (== 0) <$> rosy_send_link fd buffer (fromIntegral size) (fromIntegral count) passed

-- | A descriptor that becomes readable when a child has ended.
watchChildren :: IO Fd
watchChildren = Fd <$> orThrow "sigaction" rosy_watch_children

drain :: Fd -> IO ()
drain (Fd fd) = rosy_drain fd

data Interest = Readable | ReadableOrWritable
  deriving (Eq)

-- | Waits until a descriptor is ready or the timeout (milliseconds) has passed. The flags are (readable, writable).
poll :: [(Fd, Interest)] -> Int -> IO [(Bool, Bool)]
poll wanted milliseconds =
  withArrayLen [fd | (Fd fd, _) <- wanted] $ \count fds ->
    withArrayLen (map (events . snd) wanted) $ \_ wants ->
      allocaArray (max 1 count) $ \got -> do
        _ <- rosy_poll (fromIntegral count) fds wants got (fromIntegral milliseconds)
        map (\e -> (readable e, writable e)) <$> peekArray count got
  where
    -- poll(2): POLLIN 1, POLLOUT 4, POLLERR 8, POLLHUP 16, POLLNVAL 32.
    events Readable = 1
    events ReadableOrWritable = 5
    readable e = any (bit e) [1, 8, 16, 32]
    writable e = bit e 4
    bit :: CShort -> CShort -> Bool
    bit e b = (e `div` b) `mod` 2 == 1

data ProcessEnd = Exited Int | Signalled Int
  deriving (Eq, Show)

-- | One child that has ended, if any.
reapChild :: IO (Maybe (Int, ProcessEnd))
reapChild = alloca $ \how -> alloca $ \value -> do
  pid <- rosy_reap how value
  if pid == 0
    then pure Nothing
    else do
      h <- peek how
      v <- fromIntegral <$> peek value
      pure (Just (fromIntegral pid, if h == 0 then Exited v else Signalled v))

-- | Seconds of processor time that a child has used; none is known of one that has ended.
processorTime :: Int -> IO (Maybe Double)
processorTime pid = do
  CDouble used <- rosy_processor_time (fromIntegral pid)
  pure (if used < 0 then Nothing else Just used)

-- | Memory that a forked child shares with its parent, 'pageSize' bytes.
type SharedPage = Ptr Word32

newSharedPage :: IO SharedPage
newSharedPage = do
  page <- rosy_page
  when (page == nullPtr) (void $ orThrow "mmap" (pure (-1)))
  pure page

freeSharedPage :: SharedPage -> IO ()
freeSharedPage = rosy_page_free

-- | The current content of a page.
readSharedPage :: SharedPage -> IO ByteString
readSharedPage page = ByteString.packCStringLen (castPtr page, pageSize)

-- | Excludes the page from children that are forked later.
unmapInChildren :: SharedPage -> IO ()
unmapInChildren = rosy_page_keep

-- | A pair of connected sockets.
newSocketPair :: IO (Fd, Fd)
newSocketPair = allocaArray 2 $ \ends -> do
  _ <- orThrow "socketpair" (rosy_pair ends)
  both <- peekArray 2 ends
  case both of
    [a, b] -> pure (Fd a, Fd b)
    _ -> error "newSocketPair: two ends were asked for"

-- | Writes all bytes, blocking.
writeAll :: Fd -> ByteString -> IO ()
writeAll (Fd fd) bytes =
  void $ unsafeUseAsCStringLen bytes (\(buffer, size) -> orThrow "write" (rosy_write_all fd buffer (fromIntegral size)))

-- | Reads available bytes, blocking; empty at the end of the stream.
readSome :: Fd -> IO ByteString
readSome fd = createAndTrim chunk (\buffer -> fromIntegral <$> fdReadBuf fd buffer (fromIntegral chunk))
  where
    chunk = 65536

-- | Sets the name of this process, at most 15 characters.
setProcessName :: String -> IO ()
setProcessName name = withCString name (void . rosy_name)

-- | Drops the capabilities of this thread and of all threads and processes that it starts: what the system lets an administrator do beyond
-- the permissions of files. 'restrictChild' does it too.
dropCapabilities :: IO ()
dropCapabilities = void $ orThrow "dropping capabilities" rosy_drop_capabilities

-- | See @rosy_child_begin@: the descriptors to keep, the replacement of descriptors 0 to 2, whether writing files is forbidden, and whether
-- gaining privileges is.
restrictChild :: [Fd] -> Fd -> Bool -> Bool -> IO ()
restrictChild keep (Fd nullFd) noFiles noPrivileges =
  void $ withArrayLen [fd | Fd fd <- keep] (\n fds -> orThrow "becoming a child" (rosy_child_begin (fromIntegral n) fds nullFd (flag noFiles) (flag noPrivileges)))

-- | In a forked worker: dies with its parent, and closes the parent's descriptors except these and 0 to 2.
becomeWorker :: [Fd] -> IO ()
becomeWorker keep = void $ withArrayLen [fd | Fd fd <- keep] (\n fds -> orThrow "becoming a worker" (rosy_fork_begin (fromIntegral n) fds))

-- | Makes sure that no memory of this process is both writable and executable. 'filterRunning' keeps it so.
protectMemory :: IO ()
protectMemory = void $ orThrow "protecting memory" rosy_protect_memory

flag :: Bool -> CInt
flag = fromIntegral . fromEnum

-- | Maps the code of this process, so that it need not be mapped bit by bit when it is used, until there is something to read.
mapCode :: Fd -> IO ()
mapCode (Fd fd) = rosy_map_code fd

-- | Lowers the scheduling priority. A failure is ignored.
lowerPriority :: Int -> IO ()
lowerPriority n = void $ rosy_nice (fromIntegral n)

filterCompiling, filterRunning :: IO ()
filterCompiling = void $ orThrow "seccomp" rosy_filter_compiling
filterRunning = void $ orThrow "seccomp" rosy_filter_running

-- | Soft limit of private memory, bytes.
limitData :: Word64 -> IO ()
limitData bytes = void $ orThrow "setrlimit" (rosy_limit_data bytes)

-- | Hard limit of private memory, bytes (0: no limit), and whether new processes and threads are forbidden.
limitProcess :: Word64 -> Bool -> IO ()
limitProcess bytes alone = void $ orThrow "setrlimit" (rosy_limit_process bytes (flag alone))

-- | CPU seconds from now on.
limitCpu :: Word64 -> IO ()
limitCpu seconds = void $ orThrow "setrlimit" (rosy_limit_cpu seconds)

limitHeap :: Word64 -> IO ()
limitHeap = rosy_limit_heap

-- | Makes garbage collections rare until the heap is compacted, for work of which almost all results stay.
deferCollections :: IO ()
deferCollections = rosy_defer_collections (32 * megabyte) (70 * megabyte) >> performMinorGC
  where
    megabyte = 1024 * 1024

-- | A major collection after which the heap takes as little memory as it can. Children that are forked later share what is left. A minor one
-- before it makes all that lives old enough for the oldest generation: what is left among the young each child would copy, for 10 ms.
compactHeap :: IO ()
compactHeap = performMinorGC >> rosy_compact_begin >> performMajorGC >> rosy_compact_end

dataSegmentSize :: IO Word64
dataSegmentSize = rosy_data_size

-- | Bytes of memory of a process that no file backs, including what it shares with its parent since the fork.
anonymousMemory :: Int -> IO Word64
anonymousMemory = rosy_anonymous_memory . fromIntegral

-- | Bytes of memory that the machine has.
machineMemory :: IO Word64
machineMemory = rosy_machine_memory

-- | Sets the bytes that are allocated between two collections.
setAllocationArea :: Word64 -> IO ()
setAllocationArea bytes = rosy_area bytes >> performMinorGC

-- | The same for an area of many megabytes that is used at once, in fresh memory of large pages.
setLargeAllocationArea :: Word64 -> IO ()
setLargeAllocationArea bytes = rosy_fresh_begin bytes >> setAllocationArea bytes >> rosy_fresh_end

-- | Returns unused blocks of the allocation area to the system: most of it after a collection.
shrinkAllocationArea :: IO ()
shrinkAllocationArea = rosy_area_clear

-- | Whether collections keep what is alive where the next one finds it again, instead of beside what is shared with the parent.
keepYoung :: Bool -> IO ()
keepYoung = rosy_stay_young . flag

-- | Returns the memory that collections have left free to the system.
releaseFreeMemory :: IO ()
releaseFreeMemory = rosy_free_clear

-- | Exits at once, without finalizers and a last collection, which would take longer than the whole run.
exitNow :: Int -> IO ()
exitNow = rosy_exit . fromIntegral
