{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Rosy.Console
-- Description : Standard output of a program as text for the robot.
--
-- @putStrLn@ and @print@ of a program's @main@ write to a device in memory, whose lines travel with the next answer over the link. A process of
-- the worker has no other output. Text of an endless loop is cut, so that it does not fill the memory.
module Rosy.Console
  ( withCapturedOutput,
    printingTo,
    sayingAll,
  )
where

import Control.Concurrent.MVar (putMVar, swapMVar, takeMVar)
import Control.Exception (bracket_)
import Control.Monad ((>=>))
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import Data.IORef
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8With)
import Data.Text.Encoding.Error (lenientDecode)
import Foreign.Ptr (castPtr)
import GHC.IO.Buffer (newByteBuffer)
import GHC.IO.BufferedIO (BufferedIO (..), readBuf, readBufNonBlocking, writeBuf, writeBufNonBlocking)
import GHC.IO.Device (IODevice (..), IODeviceType (Stream), RawIO (..))
import GHC.IO.Handle.Internals (mkHandle)
import GHC.IO.Handle.Types (Handle (..), HandleType (WriteHandle))
import Rosy.Channel (Action)
import Rosy.Link
import Rosy.Robot (Say (..), pattern SayCommand)
import System.IO (BufferMode (LineBuffering), hFlush, hSetBuffering, noNewlineTranslation, stdout, utf8)

-- | Bytes that were written and not taken yet, newest piece first, and their number.
newtype Console = Console (IORef (Int, [ByteString]))

instance RawIO Console where
  read _ _ _ _ = pure 0
  readNonBlocking _ _ _ _ = pure (Just 0)
  write (Console kept) from _ count = do
    bytes <- ByteString.packCStringLen (castPtr from, count)
    modifyIORef' kept (\(size, pieces) -> if size > largestOutput then (size, pieces) else (size + count, bytes : pieces))
  writeNonBlocking console from offset count = count <$ write console from offset count

instance IODevice Console where
  ready _ _ _ = pure True
  close _ = pure ()
  devType _ = pure Stream

instance BufferedIO Console where
  newBuffer _ = newByteBuffer 4096
  fillReadBuffer = readBuf
  fillReadBuffer0 = readBufNonBlocking
  flushWriteBuffer = writeBuf
  flushWriteBuffer0 = writeBufNonBlocking

-- | The most bytes that are kept between two answers; the rest is dropped. A choice of ours.
largestOutput :: Int
largestOutput = 20000

-- | Meanwhile standard output writes into memory. The action that is handed over takes the lines since it was asked last.
withCapturedOutput :: (IO [String] -> IO a) -> IO a
withCapturedOutput use = do
  kept <- newIORef (0, [])
  console <- mkHandle (Console kept) "standard output" WriteHandle True (Just utf8) noNewlineTranslation Nothing Nothing
  hSetBuffering console LineBuffering
  hFlush stdout
  bracket_ (exchange stdout console) (exchange stdout console) . use $ do
    hFlush stdout
    (_, pieces) <- atomicModifyIORef' kept ((0, []),)
    pure (map Text.unpack (Text.lines (decodeUtf8With lenientDecode (ByteString.concat (reverse pieces)))))
  where
    exchange (FileHandle _ one) (FileHandle _ other) = takeMVar one >>= swapMVar other >>= putMVar one
    exchange _ _ = pure ()

-- | A link whose answers begin with what was printed, as texts that the robot says.
printingTo :: IO [String] -> Link -> Link
printingTo printed link =
  link
    { answer = withPrinted >=> answer link,
      end = \a ending -> withPrinted a >>= \a' -> end link a' ending
    }
  where
    withPrinted a = (\texts -> a {answerActions = sayingAll texts ++ answerActions a}) <$> printed

-- | The robot says these lines.
sayingAll :: [String] -> [Action]
sayingAll = map (SayCommand . Say)
