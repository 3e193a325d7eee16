-- |
-- Module      : Rosy.Link
-- Description : The link to a robot, as a record of functions.
--
-- The driver of the loop ("Rosy.Run") hears batches and answers them; which wire they travel on is the link's affair.
-- The simulator waits for each answer; a real robot does not wait.
module Rosy.Link
  ( -- * What it is
    Link (..),
    Opening (..),
    Batch (..),
    Answer (..),
    noAnswer,
    Ending (..),
  )
where

import Rosy.Channel (Action, Message)
import Rosy.Core (FunctionName, Topic)
import Rosy.Loop.Quiescence (Quiescence, neverQuiet)
import Rosy.Problem (Problem)
import Rosy.Provenance (Record)

-- | A robot at the other end.
data Link = Link
  { -- | Wait until the robot is there, and say what the program sends and takes: the robot's own channels, and these topics.
    open :: [Topic] -> IO Opening,
    -- | The next batch; 'Nothing' when the program is to stop.
    next :: IO (Maybe Batch),
    -- | What the program makes of the batch.
    answer :: Answer -> IO (),
    -- | The last words: what the program did in its last step, then zero velocity, then how it ended.
    end :: Answer -> Ending -> IO (),
    -- | Leaves the name of the function at work where it can be found if it never ends.
    atWork :: FunctionName -> IO (),
    -- | No function is at work.
    atRest :: IO ()
  }

-- | What is known when a run starts.
data Opening = Opening
  { -- | Seed of the random generators.
    openingSeed :: Int,
    -- | The time of day at the start of the program, seconds: 0 in the simulator, universal time on a robot.
    openingClock :: Double
  }

-- | What the robot sensed since the last batch.
data Batch = Batch
  { batchStep :: Int,
    -- | Seconds since the start of the program, from a monotonic clock.
    batchTime :: Double,
    batchMessages :: [Message],
    -- | Whether the default-rate clock ticks after the messages.
    batchTick :: Bool,
    -- | Whether what the program remembers is requested.
    batchLooks :: Bool,
    -- | Whether the provenance of the firings is requested.
    batchWatches :: Bool,
    -- | Whether the batch is of a quiet step that is over: no answer is awaited.
    batchLate :: Bool
  }

-- | What the program did with a batch.
data Answer = Answer
  { answerStep :: Int,
    answerActions :: [Action],
    answerFired :: [FunctionName],
    -- | For each function that fired, how many of the actions it sent.
    answerSent :: [Int],
    -- | The events of the batch, as Haskell shows them.
    answerSensed :: [String],
    -- | The same, and the user events that were emitted, in order.
    answerEvents :: [String],
    -- | What the program remembers, type and value, when it is requested and differs from the last report.
    answerMemory :: Maybe [(String, String)],
    -- | The firings with their provenance, when that is requested.
    answerRecords :: Maybe [Record],
    -- | What must happen before anything in the program can fire.
    answerQuiescence :: Quiescence
  }

-- | Nothing was done.
noAnswer :: Answer
noAnswer = Answer 0 [] [] [] [] [] Nothing Nothing neverQuiet

-- | How a run ended.
data Ending = EndedDone | EndedStopped | EndedError Problem
