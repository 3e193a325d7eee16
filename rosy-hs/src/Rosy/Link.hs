-- |
-- Module      : Rosy.Link
-- Description : The link to a robot, as a record of functions.
--
-- Whoever drives the loop ("Rosy.Run") hears batches and answers them; which wire they travel on is the link's affair.
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

import Rosy.Core (Action, FunctionName, Message)
import Rosy.Problem (Problem)

-- | A robot at the other end.
data Link = Link
  { -- | Wait until the robot is there, and say what the program sends and takes.
    open :: IO Opening,
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
newtype Opening = Opening
  { -- | Where the chance of this run comes from.
    openingSeed :: Int
  }

-- | What the robot sensed since the last batch.
data Batch = Batch
  { batchStep :: Int,
    -- | Seconds.
    batchTime :: Double,
    batchMessages :: [Message],
    -- | Whether the default-rate clock ticks after the messages.
    batchTick :: Bool,
    -- | Whether somebody wants to see what the program remembers.
    batchLooks :: Bool
  }

-- | What the program did with a batch.
data Answer = Answer
  { answerStep :: Int,
    answerActions :: [Action],
    answerFired :: [FunctionName],
    answerEvents :: [String],
    -- | What the program remembers, type and value, when somebody looks and it is not what they saw last.
    answerMemory :: Maybe [(String, String)]
  }

-- | Nothing was done.
noAnswer :: Answer
noAnswer = Answer 0 [] [] [] Nothing

-- | How a run ended.
data Ending = EndedDone | EndedStopped | EndedError Problem
