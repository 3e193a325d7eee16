{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Rosy.Worker.ChildProcess
-- Description : Forked child processes: checkers, which answer questions, and runs, which execute a program.
--
-- A child restricts itself, compiles, reports the result to its parent in one line, and, for a run, restricts itself further and runs
-- the program. It never returns.
module Rosy.Worker.ChildProcess
  ( Protections (..),
    allProtections,
    Settings (..),
    runChecker,
    Beginning (..),
    runProgram,
    runNextProgram,
    heapOverflowExitCode,
  )
where

import Control.Applicative ((<|>))
import Control.Exception (AsyncException (HeapOverflow), IOException, displayException, evaluate, fromException, try)
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
import Rosy.Link.Mailbox (mapMailbox, noMailbox)
import Rosy.Worker.Explanation (explainAll, withoutHiddenEnds)
import Rosy.Worker.Explanation.ConfusableCharacters (directionControls)
import Rosy.Worker.Explanation.EmptyPlaces (emptyPlaces)
import Rosy.Worker.Explanation.TextualAdvice (withTextualAdvice)
import Rosy.Worker.Ghc
import Rosy.Worker.Graph (usedTypes)
import Rosy.Worker.Problem (Problem (place), isError)
import Rosy.Worker.Protocol
import Rosy.Worker.Report (Report (..))
import Rosy.Worker.StaticAdvice (staticAdvice)
import Rosy.Worker.SystemCalls
import System.Mem (performMinorGC)
import System.Posix.IO (FdOption (NonBlockingRead), closeFd, setFdOption)
import System.Posix.Types (Fd (..))

-- | Protections. Tests switch single ones off to see whether the others suffice.
data Protections = Protections
  { -- | Safe Haskell and the lists.
    language :: Bool,
    -- | The lists of modules and extensions.
    lists :: Bool,
    -- | The seccomp filters.
    systemCalls :: Bool,
    -- | Memory limits of the run-time system and of the kernel.
    memoryLimit :: Bool,
    -- | No new processes and threads.
    processLimit :: Bool,
    -- | No file is written.
    fileLimit :: Bool,
    -- | CPU time limit.
    computingLimit :: Bool,
    -- | No privileges can be gained.
    noPrivileges :: Bool
  }

allProtections :: Protections
allProtections = Protections True True True True True True True True

data Settings = Settings
  { protections :: Protections,
    -- | Bytes that a check may allocate beyond the memory of the worker.
    compileMemory :: Word64,
    -- | CPU seconds of a whole run.
    runSeconds :: Word64,
    nullFd :: Fd
  }

-- | Exit code of the run-time system when the heap limit is reached (rts/RtsUtils.c, @EXIT_HEAPOVERFLOW@).
heapOverflowExitCode :: Int
heapOverflowExitCode = 251

-- | Niceness of a running program: lower priority than the service and the checks.
runNiceness :: Int
runNiceness = 5

-- | Answers questions with the fields of the answer until the channel closes or the process has grown too large.
runChecker :: Settings -> Session -> Fd -> IO ()
runChecker settings session service = runToExit service $ do
  enterSandbox settings [service]
  setProcessName "rosy-check"
  setAllocationArea compileAllocationArea
  atFirst <- dataSegmentSize
  let next held = do
        bytes <- readSome service
        unless (ByteString.null bytes) $ do
          let (found, rest) = splitLines held bytes
          sequence_ [either (const (pure ())) answer (parseRequest l) | Line l <- found]
          now <- dataSegmentSize
          when (now < atFirst + checkerGrowthLimit) (next rest)
      answer request = case request of
        Ask _ question -> do
          when (computingLimit (protections settings)) (limitCpu compileCpu)
          fields <- case question of
            Check source -> reportFields . fst <$> checkSource settings ForCheck session source
            Complete source at -> completionFields <$> complete session source at
          writeAll service ("C" <> line fields)
          -- Between two questions there is hardly any live data to copy.
          performMinorGC
        _ -> pure ()
  next emptyLineBuffer

-- | Bytes allocated between two collections by a checker, or by a run while it compiles a large program. A check of a hundred lines
-- allocates 25 MB; collecting in between would be a quarter of the work.
compileAllocationArea :: Word64
compileAllocationArea = 32 * 1024 * 1024

-- | The same for a running program, of which two hundred must fit into memory. A small one that begins at once keeps the initial area of every child,
-- 4 MB (rosy.cabal, @-A@).
runAllocationArea :: Word64
runAllocationArea = 1024 * 1024

-- | Characters from which on a program is compiled with the large area. Allocating that takes as long as a collection or two.
largeSourceLength :: Int
largeSourceLength = 1000

-- | Bytes by which a checker may grow before it is replaced.
checkerGrowthLimit :: Word64
checkerGrowthLimit = 128 * 1024 * 1024

-- | The report, and the program with its empty places if it can run.
checkSource :: Settings -> Purpose -> Session -> Text -> IO (Report, Maybe (Ready, [EmptyPlace]))
checkSource settings purpose session source = do
  found <- analyseProgram restriction purpose session source
  let certain = withoutHiddenEnds (explainAll (outline found) (refusals found) (messages found))
      advised = if any isError certain then certain else maybe certain (withTextualAdvice (outline found) . (certain ++) . staticAdvice (outline found)) (facts found)
      all' = advised ++ [p | p <- directionControls source, place p `notElem` map place certain]
      report = Report all' (declared found) (connected found) (network found) (onTopics found) (typed found) (grouped found)
      places = emptyPlaces (outline found) (messages found)
  pure (report, if any isError all' then Nothing else (,places) <$> ready found)
  where
    restriction
      | not (language (protections settings)) = Unrestricted
      | lists (protections settings) = Restricted
      | otherwise = SafeHaskellOnly

-- | When a program begins.
data Beginning
  = AtOnce
  | -- | At once, in a child that has been forked, and has its large allocation area, before there was a program.
    InSpare
  | -- | When the parent writes something. Until then the child has said that it is ready, and waits with as few rights as the program has.
    WhenAsked
  deriving (Eq)

-- | Answers @started@ or @refused@ with a letter before the line, then runs the program over the link.
runProgram :: Settings -> Session -> Beginning -> Fd -> Link -> SharedPage -> Order -> IO ()
runProgram settings session beginning answer link page order = runToExit answer (runOrder settings session beginning answer link page order)

-- | The same for the order that arrives with its link. Until then the child prepares what takes a compilation longer than the compiling of a small
-- program, and waits, with nothing of its parent's open.
runNextProgram :: Settings -> Session -> Fd -> SharedPage -> IO ()
runNextProgram settings session parent page = runToExit parent $ do
  becomeWorker [parent, nullFd settings]
  setProcessName "rosy-spare"
  mapCode parent
  -- An order that is there already does not wait for the large area.
  isAsked <- any fst <$> poll [(parent, Readable)] 0
  unless isAsked (setLargeAllocationArea compileAllocationArea)
  let next held passed = do
        _ <- poll [(parent, Readable)] (-1)
        got <- receive parent
        case got of
          WouldBlock -> next held passed
          Closed -> pure ()
          Bytes bytes descriptors -> case (splitLines held bytes, passed <|> descriptors) of
            ((Line l : _, _), Just link) | Right (Run _ order) <- parseRequest l -> do
              setProcessName "rosy-worker"
              runOrder settings session (if isAsked then AtOnce else InSpare) parent link page order
            ((_, rest), found) -> next rest found
  next emptyLineBuffer Nothing

runOrder :: Settings -> Session -> Beginning -> Fd -> Link -> SharedPage -> Order -> IO ()
runOrder settings session beginning answer link page order = do
  began <- getMonotonicTime
  -- What may never be run has a run's priority from the beginning, also while it is compiled.
  when (beginning == WhenAsked) (lowerPriority runNiceness)
  mailbox <- maybe (pure noMailbox) (\(Fd fd) -> mapMailbox fd) (linkMailbox link)
  enterSandbox settings [answer, linkSocket link]
  case beginning of
    AtOnce -> when isLarge (setLargeAllocationArea compileAllocationArea)
    InSpare -> pure ()
    WhenAsked -> setAllocationArea compileAllocationArea
  when (beginning == WhenAsked) (keepYoung True)
  (report, mayRun) <- checkSource settings (if isPlain order then ForPlainRun else ForRun) session source
  let found = problems report
      uses = if isPlain order then [] else usedTypes (parts report)
  case mayRun of
    Nothing -> writeAll answer ("R" <> line ("problems" .= found))
    Just (program, places) -> do
      (branches, launch) <- load session (isPlain order) program
      forgetPrograms session
      protectMemory
      -- The program uses blocking reads, whatever mode the creator of the link has set.
      setFdOption (linkSocket link) NonBlockingRead False
      when (beginning /= WhenAsked) (lowerPriority runNiceness)
      now <- getMonotonicTime
      let starting = "S" <> line ("problems" .= found <> "compile" .= (now - began) <> "uses" .= uses <> branchFields branches)
      -- These hold the whole checked program until they are computed.
      _ <- evaluate (ByteString.length starting + length (show places))
      case beginning of
        AtOnce -> when isLarge shrink
        InSpare -> pure ()
        WhenAsked -> giveBack
      size <- dataSegmentSize
      let on layer = layer (protections settings)
      when (on memoryLimit) $ limitHeap (if beginning == WhenAsked || beginning == AtOnce && isLarge then memory - min memory (compileAllocationArea - runAllocationArea) else memory)
      when (on computingLimit) $ limitCpu (runSeconds settings)
      limitProcess (if on memoryLimit then size + 2 * memory + heapSlack else 0) (on processLimit)
      when (on systemCalls) filterRunning
      when (beginning == WhenAsked) (awaitRequest answer)
      writeAll answer starting
      closeFd answer
      let Fd fd = linkSocket link
      launch fd page mailbox places
  where
    source = orderSource order
    memory = fromIntegral (max 0 (orderMemory order)) :: Word64
    -- For a small program that begins at once a larger area takes more time than it is worth.
    isLarge = Text.length source > largeSourceLength

-- | Leaves of what a compilation has allocated only what the program needs, which waits, perhaps for long. For one that begins at once this would take
-- more time than it is worth: a fifth of a run's with 501 lines. The second collection puts that beside what lives for long.
giveBack :: IO ()
giveBack = do
  performMinorGC
  keepYoung False
  shrink
  releaseFreeMemory

-- | From now on a running program's allocation area.
shrink :: IO ()
shrink = performMinorGC >> shrinkAllocationArea >> setAllocationArea runAllocationArea

-- | Says that the program is ready, and waits until it is asked for.
awaitRequest :: Fd -> IO ()
awaitRequest answer = do
  writeAll answer "P\n"
  asked <- readSome answer
  when (ByteString.null asked) (exitNow 0)

-- | Bytes beyond twice the heap limit (a collection may need twice the heap) at which the kernel limits a run. The limit of the run-time
-- system is lower and normally reached first.
heapSlack :: Word64
heapSlack = 64 * 1024 * 1024

-- | CPU seconds of a check, in case its parent does not end it.
compileCpu :: Word64
compileCpu = 60

enterSandbox :: Settings -> [Fd] -> IO ()
enterSandbox settings keep = do
  let on layer = layer (protections settings)
  restrictChild keep (nullFd settings) (on fileLimit) (on noPrivileges)
  when (on memoryLimit) $ do
    size <- dataSegmentSize
    -- Only the kernel's limit: near its own limit the run-time system collects for minutes before it fails.
    limitData (size + compileMemory settings)
  when (on computingLimit) $ limitCpu compileCpu
  when (systemCalls (protections settings)) filterCompiling

-- | Runs the child as a main thread, so that heap overflow is an exception in it, and exits. A failure of the compiler itself is sent to
-- the parent after an exclamation mark.
runToExit :: Fd -> IO () -> IO ()
runToExit answer life = asMain $ do
  outcome <- try life
  case outcome of
    Right () -> exitNow 0
    Left e
      | Just HeapOverflow <- fromException e -> exitNow heapOverflowExitCode
      | otherwise -> do
        _ <- try (writeAll answer ("!" <> encodeUtf8 (Text.pack (takeWhile (/= '\n') (displayException e))) <> "\n")) :: IO (Either IOException ())
        exitNow 1

line :: Series -> ByteString
line fields = Lazy.toStrict (encodingToLazyByteString (pairs fields)) <> "\n"
