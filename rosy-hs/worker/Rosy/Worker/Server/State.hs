-- |
-- Module      : Rosy.Worker.Server.State
-- Description : State of the worker: the runs, questions, preparations and forked workers that it has in hand.
module Rosy.Worker.Server.State
  ( Config (..),
    Job (..),
    RunRequest (..),
    Spare (..),
    ForkRequest (..),
    State (..),
    newState,

    -- * What it does now
    isCompiling,
    isPreparing,
    isBusy,
    isOccupied,

    -- * Small steps
    reply,
    signal,
    closeInstead,
  )
where

import Control.Monad (forM_)
import Data.ByteString (ByteString)
import qualified Data.Map.Strict as Map
import Data.Sequence (Seq (..), (|>))
import qualified Data.Sequence as Seq
import Data.Text (Text)
import Data.Word (Word64)
import Rosy.Worker.CheckerPool
import Rosy.Worker.ChildProcess
import Rosy.Worker.Ghc (compilerVersion)
import Rosy.Worker.LruCache
import Rosy.Worker.Preparations
import Rosy.Worker.Protocol
import Rosy.Worker.SystemCalls
import Rosy.Worker.TimeBudget
import System.Posix.Signals (Signal, signalProcess)
import System.Posix.Types (Fd)

data Config = Config
  { socket :: Fd,
    settings :: Settings,
    -- | Seconds of processor time that reading and checking a program may take.
    compileSeconds :: Double,
    -- | How many checks, and how many runs besides, compile at once.
    maxConcurrentChecks :: Int,
    -- | Bytes of memory of all children.
    memoryTotal :: Word64
  }

-- | A run, or the preparation of one.
data Job = Job
  { jobId :: Id,
    -- | Whether the run has been asked for.
    wanted :: Bool,
    -- | Whether its child has compiled the program and waits.
    ready :: Bool,
    -- | Whether its child is stopped, because others have something to do.
    paused :: Bool,
    -- | The run to begin with if its prepared child is lost before it has answered.
    instead :: Maybe RunRequest,
    -- | Shared page with the active function.
    page :: SharedPage,
    -- | Whether the program has started.
    started :: Bool,
    -- | Present until the child has closed it.
    answers :: Maybe Fd,
    inputBuffer :: LineBuffer,
    -- | Time that is left for compilation.
    budget :: Maybe TimeBudget,
    answered :: Bool,
    -- | The limit for which it was killed.
    overrun :: Maybe Overrun,
    -- | Failure of the compiler itself.
    compilerFailure :: Text
  }

-- | A child that has been forked before its run is asked for: a fork, and what it leaves to be mapped, take as long as compiling a small program. Only plain
-- runs begin in it, which come one after the other while a person waits for each.
data Spare
  = -- | No plain run has been asked for since one was lost.
    NotWanted
  | Missing
  | -- | Process id, channel, and the shared page with the active function.
    Spare Int Fd SharedPage

-- | A run that waits for others to be compiled.
data RunRequest = RunRequest Id Order Link

-- | A worker to be forked: id, socket.
data ForkRequest = ForkRequest Id Fd

data State = State
  { incoming :: LineBuffer,
    -- | Received descriptors whose run request has not arrived yet.
    pendingDescriptors :: Seq Link,
    outgoing :: Seq ByteString,
    -- | By process id.
    jobs :: Map.Map Int Job,
    pool :: CheckerPool,
    -- | Questions that are not assigned yet.
    waiting :: Seq (Id, Question),
    -- | Runs whose compilation has not begun.
    waitingRuns :: Seq RunRequest,
    preparations :: Preparations,
    spare :: Spare,
    -- | Workers that are not forked yet.
    waitingForks :: Seq ForkRequest,
    -- | Forked workers, by process id.
    workers :: Map.Map Int Id,
    -- | When memory is looked at again; 'getMonotonicTime'.
    nextLook :: Double,
    -- | By 'questionBytes'.
    cache :: LruCache ByteString ByteString,
    peerGone :: Bool
  }

-- | Nothing is in hand, and the service is told that the worker is ready.
newState :: State
newState = State emptyLineBuffer Seq.empty (Seq.singleton (answerLine (Ready compilerVersion))) Map.empty emptyPool Seq.empty Seq.empty noPreparations NotWanted Seq.empty Map.empty 0 emptyCache False

-- | Whether a run that has been asked for is being compiled.
isCompiling :: Job -> Bool
isCompiling job = wanted job && not (answered job)

-- | Whether a program is compiled that may never be run.
isPreparing :: Job -> Bool
isPreparing job = not (wanted job || ready job)

-- | Whether there is a question, or a run to compile.
isBusy :: State -> Bool
isBusy s = not (Seq.null (waiting s) && Seq.null (waitingRuns s)) || any snd (memberProcesses (pool s)) || any isCompiling (jobs s)

-- | Whether a child compiles or a program runs.
isOccupied :: State -> Bool
isOccupied s = any (\job -> wanted job || isPreparing job) (jobs s) || any snd (memberProcesses (pool s))

reply :: Answer -> State -> State
reply answer s = s {outgoing = outgoing s |> answerLine answer}

signal :: Signal -> Int -> IO ()
signal what pid = signalProcess what (fromIntegral pid)

-- | Closes the link that is kept in case that a prepared child is lost.
closeInstead :: Job -> IO ()
closeInstead job = forM_ (instead job) (\(RunRequest _ _ kept) -> closeLink kept)
