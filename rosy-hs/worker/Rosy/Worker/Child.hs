{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Child
-- Description : What a forked child does, from its first breath to its exit.
--
-- A child gives up what it does not need, compiles, says what it found to its parent in one line, and, when it is to run
-- the program, gives up the rest and runs it. It never returns.
module Rosy.Worker.Child
  ( Layers (..),
    allLayers,
    Settings (..),
    answerChild,
    runChild,
    ranOutOfMemory,
  )
where

import Control.Exception (AsyncException (HeapOverflow), IOException, displayException, fromException, try)
import Control.Monad (unless, when)
import Data.Aeson (Series, pairs, (.=))
import Data.Aeson.Encoding (encodingToLazyByteString)
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Lazy as Lazy
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (encodeUtf8)
import Data.Word (Word64)
import GHC.Clock (getMonotonicTime)
import Rosy.Worker.Ghc
import Rosy.Worker.Kind (explainAll)
import Rosy.Worker.Problem (Report (..), isError)
import Rosy.Worker.Sys
import Rosy.Worker.Wire
import System.Mem (performMinorGC)
import System.Posix.IO (FdOption (NonBlockingRead), closeFd, setFdOption)
import System.Posix.Types (Fd (..))

-- | The protections, each of which can be switched off to see what the others catch.
data Layers = Layers
  { -- | Safe Haskell, and what goes beyond it.
    language :: Bool,
    -- | The lists of modules and extensions.
    lists :: Bool,
    -- | The seccomp filters.
    systemCalls :: Bool,
    -- | The run-time system's and the kernel's limits of memory.
    memoryLimit :: Bool,
    -- | No further processes and threads.
    processLimit :: Bool,
    -- | No files are written.
    fileLimit :: Bool,
    -- | Seconds of computing.
    computingLimit :: Bool,
    -- | No rights can be gained.
    noPrivileges :: Bool
  }

allLayers :: Layers
allLayers = Layers True True True True True True True True

data Settings = Settings
  { layers :: Layers,
    -- | Bytes a check may take beyond what the worker has already.
    compileMemory :: Word64,
    -- | Seconds that a run may compute, all its steps together.
    runSeconds :: Word64,
    nullFd :: Fd
  }

-- | Exit code of the run-time system when the heap limit is reached (rts/RtsUtils.c, @EXIT_HEAPOVERFLOW@).
ranOutOfMemory :: Int
ranOutOfMemory = 251

-- | How nice a running program is: below the service and the checks.
runNiceness :: Int
runNiceness = 5

-- | Answers one question after the other, each with the fields of its answer, until nobody asks any more or it has grown too large.
answerChild :: Settings -> Session -> Fd -> IO ()
answerChild settings session service = alone service $ do
  begin settings [service]
  beCalled "rosy-check"
  areaOf largeArea
  atFirst <- dataSize
  let next held = do
        bytes <- readSome service
        unless (ByteString.null bytes) $ do
          let (found, rest) = cut held bytes
          sequence_ [either (const (pure ())) answer (parseRequest l) | Line l <- found]
          now <- dataSize
          when (now < atFirst + mostGrown) (next rest)
      answer request = case request of
        Ask _ question -> do
          when (computingLimit (layers settings)) (limitCpu compileCpu)
          fields <- case question of
            Check source -> reportFields . fst <$> judge settings ToKnow session source
            Complete source at -> completionFields <$> complete session source at
          writeAll service ("C" <> line fields)
          -- Now, when nothing of the question is needed any more, there is next to nothing to collect.
          performMinorGC
        _ -> pure ()
  next noLines

-- | Bytes that may be allocated between two collections by a child that checks programs, or compiles a large one: a program of a
-- hundred lines takes 25 MB to check, and collecting in between would be a quarter of the work.
largeArea :: Word64
largeArea = 32 * 1024 * 1024

-- | The same for a running program, of which two hundred shall fit. What every child is born with (rosy.cabal, @-A@).
smallArea :: Word64
smallArea = 4 * 1024 * 1024

-- | Characters from which on a program gets the large area while it is compiled: making one takes as long as a collection or two.
largeSource :: Int
largeSource = 1000

-- | Bytes by which a child that answers questions may grow before a new one takes its place.
mostGrown :: Word64
mostGrown = 128 * 1024 * 1024

-- | The report, and the program if it may run.
judge :: Settings -> Aim -> Session -> Text -> IO (Report, Maybe Ready)
judge settings aim session source = do
  found <- analyse guarded aim session source
  let all' = refusals found ++ explainAll (outline found) (messages found)
      report = Report all' (declared found) (connected found) (typed found)
  pure (report, if any isError all' then Nothing else ready found)
  where
    guarded
      | not (language (layers settings)) = Unguarded
      | lists (layers settings) = Guarded
      | otherwise = OnlySafe

-- | Answers @started@ or @refused@ with a letter before the line, then runs the program over the link.
runChild :: Settings -> Session -> Fd -> Fd -> Page -> Word64 -> Text -> IO ()
runChild settings session answer link page memory source = alone answer $ do
  began <- getMonotonicTime
  begin settings [answer, link]
  when isLarge (areaOf largeArea)
  (report, mayRun) <- judge settings ToRun session source
  let found = problems report
  case mayRun of
    Nothing -> writeAll answer ("R" <> line ("problems" .= found))
    Just program -> do
      launch <- load session program
      -- Whoever made the link may not have wanted to wait; the program does.
      setFdOption link NonBlockingRead False
      beNice runNiceness
      when isLarge (performMinorGC >> clearArea >> areaOf smallArea)
      size <- dataSize
      let on layer = layer (layers settings)
      when (on memoryLimit) $ limitHeap (if isLarge then memory - min memory (largeArea - smallArea) else memory)
      when (on computingLimit) $ limitCpu (runSeconds settings)
      limitProcess (if on memoryLimit then size + 2 * memory + heapSlack else 0) (on processLimit)
      now <- getMonotonicTime
      writeAll answer ("S" <> line ("problems" .= found <> "compile" .= (now - began)))
      closeFd answer
      when (systemCalls (layers settings)) filterRunning
      let Fd fd = link
      launch fd page
  where
    isLarge = Text.length source > largeSource

-- | Bytes that the kernel grants beyond twice the heap limit, which a collection may need for a moment. The run-time system's own
-- limit is the one that is meant to be reached; the kernel's is there in case it is not.
heapSlack :: Word64
heapSlack = 64 * 1024 * 1024

-- | Seconds of computing for a check, should its parent not end it in time.
compileCpu :: Word64
compileCpu = 60

begin :: Settings -> [Fd] -> IO ()
begin settings keep = do
  let on layer = layer (layers settings)
  beginChild keep (nullFd settings) (on fileLimit) (on noPrivileges)
  when (on memoryLimit) $ do
    size <- dataSize
    -- Only the kernel's limit: close to its own, the run-time system would collect for minutes before it gives up.
    limitData (size + compileMemory settings)
  when (on computingLimit) $ limitCpu compileCpu
  when (systemCalls (layers settings)) filterCompiling

-- | Lives as a program's main does, so that a full heap is an exception there, and leaves at once. What went wrong
-- in the compiler itself goes to the parent after an exclamation mark.
alone :: Fd -> IO () -> IO ()
alone answer life = asMain $ do
  outcome <- try life
  case outcome of
    Right () -> exitNow 0
    Left e
      | Just HeapOverflow <- fromException e -> exitNow ranOutOfMemory
      | otherwise -> do
        _ <- try (writeAll answer ("!" <> encodeUtf8 (Text.pack (takeWhile (/= '\n') (displayException e))) <> "\n")) :: IO (Either IOException ())
        exitNow 1

line :: Series -> ByteString
line fields = Lazy.toStrict (encodingToLazyByteString (pairs fields)) <> "\n"
