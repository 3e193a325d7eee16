-- |
-- Module      : Rosy.BranchCoverage
-- Description : Branch coverage of a firing: which equations, guards and alternatives it took (rule R12).
--
-- The worker compiles a program so that each branch between which a function chooses evaluates 'tick' with the branch's number when it is
-- taken, and then the branch itself. Nothing else changes: 'tick' is total, forces nothing of the program, and is not evaluated earlier or
-- more often than the branch. A program that was compiled otherwise has no branches.
module Rosy.BranchCoverage
  ( -- * Branches
    Branch,
    TakenBranch (..),
    setBranches,

    -- * Recording
    tick,
    recordingBranches,
  )
where

import Control.Exception (onException)
import Control.Monad (when)
import Data.ByteString (ByteString)
import Data.IORef
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.Maybe (mapMaybe)
import System.IO.Unsafe (unsafeDupablePerformIO, unsafePerformIO)

-- | Where it starts and ends, as line and column from 1; the names of the definitions around it, outermost first; its kind, a word of
-- @protocol/README.md@ section 2; its number among the branches of its choice, from 1; and what it is told by: left side, pattern or guard.
type Branch = ((Int, Int), (Int, Int), [String], String, Int, String)

-- | A branch as a record tells it. It is the same each time that the branch is taken, and put into words once.
data TakenBranch = TakenBranch
  { -- | The characters of its names and of what it is told by.
    takenSize :: Int,
    takenText :: ByteString
  }

-- The branches of the program of this process, by number. 'tick' stands inside of the program's functions, so none of these can be arguments.
branches :: IORef (IntMap.IntMap TakenBranch)
branches = unsafePerformIO (newIORef IntMap.empty)
{-# NOINLINE branches #-}

-- | The branches of the program that this process runs, numbered from 0, and how one is told.
setBranches :: (Branch -> ByteString) -> [Branch] -> IO ()
setBranches told = writeIORef branches . IntMap.fromList . zip [0 ..] . map taken
  where
    taken branch@(_, _, definitions, _, _, shown) = TakenBranch (length shown + sum (map length definitions)) (told branch)

-- | The branches taken so far, and the same newest first; nothing while no firing is recorded.
data Recording = Off | On !IntSet.IntSet [Int]

recording :: IORef Recording
recording = unsafePerformIO (newIORef Off)
{-# NOINLINE recording #-}

-- | The branch of this number is taken.
tick :: Int -> ()
tick branch = unsafeDupablePerformIO $ do
  now <- readIORef recording
  case now of
    On taken inOrder | branch `IntSet.notMember` taken -> writeIORef recording (On (IntSet.insert branch taken) (branch : inOrder))
    _ -> pure ()
{-# NOINLINE tick #-}

-- | Run an action; with the condition also record the branches that are taken meanwhile, each once, in the order in which each was taken
-- first. The text of the program limits how many these are.
recordingBranches :: Bool -> IO a -> IO (a, [TakenBranch])
recordingBranches isRecorded action = do
  when isRecorded (writeIORef recording (On IntSet.empty []))
  result <- action `onException` writeIORef recording Off
  now <- readIORef recording
  case now of
    Off -> pure (result, [])
    On _ inOrder -> do
      writeIORef recording Off
      known <- readIORef branches
      pure (result, mapMaybe (`IntMap.lookup` known) (reverse inOrder))
