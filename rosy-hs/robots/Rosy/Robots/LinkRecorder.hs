{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.LinkRecorder
-- Description : Recorder of what goes to and fro between a program and a real robot.
--
-- In: lines of the robot link, and commands as they go to the robot. Out: a file, which the service turns into an MCAP file
-- (@protocol/README.md@ section 7.1). Recording never delays a run: a thread of its own writes, and what it cannot
-- write in time is left out and counted.
module Rosy.Robots.LinkRecorder
  ( Recorder,
    withRecorder,
    beginRecording,
    endRecording,
    LineSource (..),
    recordLines,
    recordedConnection,
  )
where

import Control.Concurrent.Async (link, wait, withAsync)
import Control.Concurrent.STM
import Control.Exception (IOException, finally, try)
import Control.Monad (void, when)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as L
import qualified Data.ByteString.Lazy.Char8 as LC
import Data.Foldable (traverse_)
import Data.Int (Int64)
import Data.Time.Clock.POSIX (getPOSIXTime)
import Rosy.Robots.Connection (Connection (..))
import Rosy.Robots.PipeCodec (commandLine)
import System.IO (Handle, IOMode (WriteMode), hClose, hFlush, openBinaryFile)
import System.Timeout (timeout)

-- | Where a line comes from.
data LineSource
  = -- | of the robot, for the program
    ToProgram
  | -- | of the program
    FromProgram
  | -- | a command that is sent to the robot, after limits and safety rules
    ToRobot
  deriving (Eq, Show)

data Recorder = Recorder
  { entries :: TBQueue Entry,
    isRecording :: TVar Bool,
    -- | entries that did not fit into the queue
    leftOut :: TVar Int
  }

data Entry
  = Begin FilePath
  | -- | nanoseconds since 1970; whole lines, each with its newline
    Lines Integer LineSource L.ByteString
  | -- | set when all before it is in the file
    End (TMVar ())
  | Leave

-- | The file of a recording, and the bytes in it.
data Output = Closed | Open Handle Int64

-- | Entries that wait for the disk: six seconds of a run.
maxQueuedEntries :: Num n => n
maxQueuedEntries = 1000

-- | Bytes of a recording, about six hours of a Kobuki; a choice of ours.
maxRecording :: Int64
maxRecording = 500000000

-- | Microseconds that the end of a recording is waited for.
endTimeout :: Int
endTimeout = 2000000

withRecorder :: (Recorder -> IO a) -> IO a
withRecorder use = do
  recorder <- Recorder <$> newTBQueueIO maxQueuedEntries <*> newTVarIO False <*> newTVarIO 0
  withAsync (writeEntries recorder Closed) $ \writer -> do
    link writer
    use recorder `finally` (endRecording recorder >> atomically (writeTBQueue (entries recorder) Leave) >> timeout endTimeout (wait writer))

-- | Records into a new file from now on. A file that cannot be made is left out.
beginRecording :: Recorder -> FilePath -> IO ()
beginRecording recorder path = atomically (writeTVar (leftOut recorder) 0 >> writeTBQueue (entries recorder) (Begin path) >> writeTVar (isRecording recorder) True)

-- | Returns when the recording is in its file, or the disk takes too long.
endRecording :: Recorder -> IO ()
endRecording recorder = do
  done <- newEmptyTMVarIO
  was <- atomically $ do
    was <- swapTVar (isRecording recorder) False
    was <$ when was (writeTBQueue (entries recorder) (End done))
  when was . void $ timeout endTimeout (atomically (takeTMVar done))

-- | Whole lines, each with its newline. Does not block.
recordLines :: Recorder -> LineSource -> L.ByteString -> IO ()
recordLines recorder source text = do
  on <- readTVarIO (isRecording recorder)
  when on $ do
    time <- (\t -> floor (t * 1000000000)) <$> getPOSIXTime
    atomically $ do
      full <- isFullTBQueue (entries recorder)
      if full then modifyTVar' (leftOut recorder) (+ 1) else writeTBQueue (entries recorder) (Lines time source text)

-- | The same connection, whose commands are recorded.
recordedConnection :: Recorder -> Connection -> Connection
recordedConnection recorder connection =
  connection {sendCommand = \t a -> sendCommand connection t a >> traverse_ (recordLines recorder ToRobot . Builder.toLazyByteString) (commandLine a)}

writeEntries :: Recorder -> Output -> IO ()
writeEntries recorder output = do
  entry <- atomically (readTBQueue (entries recorder))
  case entry of
    Begin path -> close output >> either unwritable (`Open` 0) <$> try (openBinaryFile path WriteMode) >>= writeEntries recorder
    Lines time source text -> append output (foldMap (entryLine time source) (LC.lines text)) >>= writeEntries recorder
    End done -> do
      lost <- readTVarIO (leftOut recorder)
      _ <- append output (". " <> Builder.intDec lost <> "\n") >>= close
      atomically (putTMVar done ())
      writeEntries recorder Closed
    Leave -> close output
  where
    unwritable :: IOException -> Output
    unwritable _ = Closed
    close Closed = pure ()
    close (Open file _) = void (try (hClose file) :: IO (Either IOException ()))

entryLine :: Integer -> LineSource -> L.ByteString -> Builder.Builder
entryLine time source text = Builder.integerDec time <> sign <> Builder.lazyByteString text <> "\n"
  where
    sign = case source of
      ToProgram -> " > "
      FromProgram -> " < "
      ToRobot -> " ! "

-- | A recording that is too long, or whose disk is full, ends without its last line.
append :: Output -> Builder.Builder -> IO Output
append output text = case output of
  Closed -> pure Closed
  Open file size -> do
    let bytes = Builder.toLazyByteString text
        size' = size + L.length bytes
    written <- if size' > maxRecording then pure (Left ()) else either failed Right <$> try (L.hPut file bytes >> hFlush file)
    case written of
      Right () -> pure (Open file size')
      Left () -> Closed <$ (try (hClose file) :: IO (Either IOException ()))
  where
    failed :: IOException -> Either () ()
    failed _ = Left ()
