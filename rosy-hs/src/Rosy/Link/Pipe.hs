{-# LANGUAGE ForeignFunctionInterface #-}

-- |
-- Module      : Rosy.Link.Pipe
-- Description : The link to the simulator over one file descriptor.
--
-- Lines in, lines out, in lockstep: a batch is read up to its @step@ line and answered in one write. Plain blocking
-- calls with a buffer of its own, so that it works in a process that was forked a moment ago and has no I/O manager.
-- A batch that comes in the mailbox is answered there.
-- What the lines mean is in "Rosy.Wire". Never writes to standard output, which belongs to the program.
module Rosy.Link.Pipe
  ( pipeLink,
  )
where

import Control.Exception
import Control.Monad (unless, when)
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Internal as Internal
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Unsafe as Unsafe
import Data.IORef
import Data.Word (Word32, Word8)
import Foreign.C.Error (throwErrnoIfMinus1Retry)
import Foreign.C.Types (CInt (..), CSize (..))
import Foreign.Marshal.Utils (copyBytes)
import Foreign.Ptr (Ptr, castPtr, nullPtr, plusPtr)
import Foreign.Storable (peek, poke)
import Rosy.Channel (Message)
import Rosy.Core (Topic (..), TopicUse (..), nameBytes)
import Rosy.Link
import Rosy.Link.Mailbox
import Rosy.Problem (Fault (..))
import Rosy.Wire
import System.Posix.Types (CSsize (..))

foreign import ccall safe "read" c_read :: CInt -> Ptr Word8 -> CSize -> IO CSsize

foreign import ccall safe "write" c_write :: CInt -> Ptr Word8 -> CSize -> IO CSsize

-- | A link over a stream descriptor, used in both directions, a page for the name of the function at work, and a mailbox (see
-- 'Rosy.Launch.onPipe').
pipeLink :: CInt -> Ptr Word32 -> Mailbox -> IO Link
pipeLink descriptor page mailbox = do
  rest <- newIORef ByteString.empty
  telling <- newIORef (Telling False False)
  taken <- newIORef []
  -- Whether the latest bytes came in the mailbox.
  inMailbox <- newIORef False
  -- Whether the next batch is expected in the mailbox, as it was said with the latest one or the start. After the answer it may already be said of
  -- the batch after that.
  isExpected <- newIORef False
  let fromLink = writeIORef inMailbox False >> readPiece descriptor
      fromMailbox = takeBatch descriptor mailbox >>= maybe fromLink (\bytes -> bytes <$ writeIORef inMailbox True)
      heard more = do
        bytes <- readLineFrom more rest
        names <- readIORef taken
        case readLineTaking names bytes of
          Right l -> pure l
          Left _ -> throwIO (Malformed (Char8.unpack (ByteString.take 500 bytes)))
  pure
    Link
      { open = \topics -> do
          l <- heard fromLink
          case l of
            StartLine 1 seed clock trace quiet -> do
              writeIORef telling (Telling trace quiet)
              writeIORef taken [topicName t | t <- topics, topicUse t == Taken]
              writeIORef isExpected =<< isExpectedIn mailbox
              send descriptor (writeOpening (mailbox /= noMailbox) topics)
              pure (Opening seed clock)
            _ -> throwIO (Malformed "the first line is not a start of protocol 1"),
        next = do
          expected <- readIORef isExpected
          found <- batch (heard (if expected then fromMailbox else fromLink)) []
          found <$ (writeIORef isExpected =<< isExpectedIn mailbox),
        answer = \a -> do
          what <- readIORef telling
          there <- readIORef inMailbox
          let written = writeAnswer what a
          isLeft <- if there then putAnswer mailbox written else pure False
          unless isLeft (send descriptor written),
        end = \a ending -> do
          what <- readIORef telling
          send descriptor (writeEnding what a ending),
        atWork = unless (page == nullPtr) . leave page . nameBytes,
        atRest = unless (page == nullPtr) (poke page 0)
      }

-- | Messages up to the end of the step.
batch :: IO Line -> [Message] -> IO (Maybe Batch)
batch heard messages = do
  l <- heard
  case l of
    SensorLine found -> batch heard (reverse found ++ messages)
    StepLine step time looks watches late -> pure (Just (Batch step time (reverse messages) (step `mod` ticksEvery == 0) looks watches late))
    StopLine -> pure Nothing
    StartLine {} -> throwIO (Malformed "a second start")

-- | The next line without its end. The action gives more bytes; the reference keeps what was read beyond the line.
readLineFrom :: IO ByteString -> IORef ByteString -> IO ByteString
readLineFrom more rest = readIORef rest >>= go []
  where
    -- Pieces without a line end, newest first.
    go pieces bytes = case ByteString.elemIndex 10 bytes of
      Just i -> do
        writeIORef rest $! Unsafe.unsafeDrop (i + 1) bytes
        let lastPiece = Unsafe.unsafeTake i bytes
        pure (if null pieces then lastPiece else ByteString.concat (reverse (lastPiece : pieces)))
      Nothing -> more >>= go (if ByteString.null bytes then pieces else bytes : pieces)

-- | Some bytes from the descriptor.
readPiece :: CInt -> IO ByteString
readPiece descriptor = do
  bytes <- lost (Internal.createAndTrim pieceSize (\p -> fromIntegral <$> throwErrnoIfMinus1Retry "read" (c_read descriptor p (fromIntegral pieceSize))))
  when (ByteString.null bytes) (throwIO (LinkLost "closed"))
  pure bytes

-- | How much is read at once, bytes: several times a batch, which is below 1 kB, and less than what GHC gives a block of memory of its own.
pieceSize :: Int
pieceSize = 3000

-- | Write all of it.
send :: CInt -> Builder.Builder -> IO ()
send descriptor builder = mapM_ piece (Lazy.toChunks (Builder.toLazyByteString builder))
  where
    piece bytes = unless (ByteString.null bytes) $ do
      n <- lost (Unsafe.unsafeUseAsCStringLen bytes (\(p, len) -> throwErrnoIfMinus1Retry "write" (c_write descriptor (castPtr p) (fromIntegral len))))
      piece (ByteString.drop (fromIntegral n) bytes)

-- | A descriptor that fails has lost its other end.
lost :: IO a -> IO a
lost io = io `catch` \e -> throwIO (LinkLost (show (e :: IOException)))

-- | Write a name into the page. Its first word says at which byte the name stands, 0 for none; there, a word with the name's length,
-- then its bytes. The next name is written where none is shown and then shown with one write: a program that is killed at any moment
-- was at work on one of the two.
leave :: Ptr Word32 -> ByteString -> IO ()
leave page name = do
  place <- other <$> peek page
  let size = min (ByteString.length name) nameLimit
      begin = page `plusPtr` fromIntegral place
  Unsafe.unsafeUseAsCString name (\p -> copyBytes (begin `plusPtr` 4) p size)
  poke begin (fromIntegral size :: Word32)
  poke page place
  where
    other shown = if shown == firstName then secondName else firstName

-- | Where the two names stand in a page of 4096 bytes.
firstName, secondName :: Word32
firstName = 4
secondName = 2048

-- | What fits between them after a length, bytes.
nameLimit :: Int
nameLimit = fromIntegral (secondName - firstName) - 4
