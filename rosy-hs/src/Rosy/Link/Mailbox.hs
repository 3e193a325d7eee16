{-# LANGUAGE ForeignFunctionInterface #-}

-- |
-- Module      : Rosy.Link.Mailbox
-- Description : Mailbox of a lockstep: memory that the simulator and a program share, for the bytes of a step.
--
-- For as long as both have a core of their own, neither makes a system call: each writes the bytes of its turn there, and then their
-- length, for which the other busy-waits. What does not fit goes over the link, and so does everything when the simulator says so in
-- the mailbox. Only on processors that keep the order of writes (x86-64). The layout is that of @protocol/README.md@ section 2.
module Rosy.Link.Mailbox
  ( Mailbox,
    noMailbox,
    mapMailbox,
    isExpectedIn,
    takeBatch,
    putAnswer,
  )
where

import Control.Monad (when)
import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder.Extra as Builder
import qualified Data.ByteString.Internal as Internal
import Data.Int (Int16, Int64)
import Data.Word (Word32, Word8)
import Foreign.C.Error (throwErrno)
import Foreign.C.Types (CInt (..), CSize (..), CUInt (..), CULong (..))
import Foreign.Marshal.Alloc (allocaBytes)
import Foreign.Marshal.Utils (copyBytes)
import Foreign.Ptr (Ptr, castPtr, nullPtr, plusPtr)
import Foreign.Storable (peek, poke)

-- | Where the memory begins; a null pointer when the program has none.
type Mailbox = Ptr Word32

-- | Everything goes over the link.
noMailbox :: Mailbox
noMailbox = nullPtr

foreign import ccall unsafe "mmap" c_mmap :: Ptr () -> CSize -> CInt -> CInt -> CInt -> Int64 -> IO (Ptr Word32)

foreign import ccall safe "poll" c_poll :: Ptr () -> CULong -> CInt -> IO CInt

foreign import ccall unsafe "usleep" c_usleep :: CUInt -> IO CInt

-- | The mailbox in a file of memory. Throws an 'IOError' when the descriptor is none.
mapMailbox :: CInt -> IO Mailbox
mapMailbox descriptor = do
  -- PROT_READ and PROT_WRITE, MAP_SHARED. mmap(2).
  found <- c_mmap nullPtr (fromIntegral mailboxSize) 3 1 descriptor 0
  when (found == nullPtr `plusPtr` (-1)) (throwErrno "mmap")
  pure found

-- | Bytes of the memory, and where there is: the length of a batch, that of an answer, whether the next batch comes here, a batch, an
-- answer. The lengths are in different cache lines, 0 while nothing is there.
mailboxSize, batchLengthAt, answerLengthAt, expectedAt, batchAt, answerAt :: Int
mailboxSize = 65536
batchLengthAt = 0
answerLengthAt = 64
expectedAt = 128
batchAt = 4096
answerAt = 32768

word :: Mailbox -> Int -> Ptr Word32
word = plusPtr

-- | Whether the batch after the latest one comes here. The simulator says so before it sends the latest one, and may change it as soon
-- as that is answered.
isExpectedIn :: Mailbox -> IO Bool
isExpectedIn box
  | box == nullPtr = pure False
  | otherwise = (/= 0) <$> peek (word box expectedAt)

-- | The next batch; nothing when there is something to read on the link instead. Busy-waits first. Then the simulator waits for a core
-- perhaps, which may be this one: short sleeps lend it, and later a look once in a millisecond.
takeBatch :: CInt -> Mailbox -> IO (Maybe ByteString)
takeBatch link box = spin spinLimit
  where
    spin left = look $ if left > 0 then spin (left - 1) else sleep maxShortSleeps
    sleep :: Int -> IO (Maybe ByteString)
    sleep left = do
      _ <- if left > 0 then c_usleep shortSleep else pure 0
      hasMore <- hasBytes link (if left > 0 then 0 else 1)
      if hasMore then pure Nothing else look (sleep (max 0 (left - 1)))
    look whenEmpty = do
      size <- fromIntegral <$> peek (word box batchLengthAt)
      if size /= 0 then Just <$> takeOut size else whenEmpty
    takeOut size = Internal.create size (\p -> copyBytes p (box `plusPtr` batchAt) size) <* poke (word box batchLengthAt) 0

-- | How often the program looks before it sleeps: for some 0.15 ms, three times what the simulator takes for a step.
spinLimit :: Int
spinLimit = 150000

-- | Microseconds of a short sleep, and how many follow one another.
shortSleep :: CUInt
shortSleep = 40

maxShortSleeps :: Int
maxShortSleeps = 50

-- | Whether a descriptor has something to read within so many milliseconds.
hasBytes :: CInt -> CInt -> IO Bool
hasBytes descriptor milliseconds = allocaBytes 8 $ \entry -> do
  -- `struct pollfd`: descriptor, events asked for (POLLIN), events found. poll(2).
  poke (castPtr entry) descriptor
  poke (castPtr (entry `plusPtr` 4)) (1 :: Int16)
  (> 0) <$> c_poll entry 1 milliseconds

-- | Leaves an answer there, if it fits.
putAnswer :: Mailbox -> Builder -> IO Bool
putAnswer box answer = do
  (size, rest) <- Builder.runBuilder answer (box `plusPtr` answerAt :: Ptr Word8) (mailboxSize - answerAt)
  case rest of
    Builder.Done -> True <$ poke (word box answerLengthAt) (fromIntegral size)
    _ -> pure False
