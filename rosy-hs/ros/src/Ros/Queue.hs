-- |
-- Module      : Ros.Queue
-- Description : A queue that forgets its oldest value when it is full.
--
-- What a slow reader gets: the newest values, in order, and a count of those it missed.
module Ros.Queue
  ( Queue,
    newQueue,
    push,
    pop,
    popAll,
    isEmpty,
    missed,
  )
where

import Control.Concurrent.STM
import Data.Foldable (toList)
import Data.Sequence (Seq, ViewL (..), (|>))
import qualified Data.Sequence as Seq

data Queue a = Queue {bound :: !Int, items :: !(TVar (Seq a)), lost :: !(TVar Int)}

-- | Room for so many values, at least one.
newQueue :: Int -> IO (Queue a)
newQueue n = Queue (max 1 n) <$> newTVarIO Seq.empty <*> newTVarIO 0

push :: Queue a -> a -> STM ()
push q x = do
  xs <- readTVar (items q)
  if Seq.length xs < bound q
    then writeTVar (items q) $! xs |> x
    else do
      writeTVar (items q) $! Seq.drop 1 xs |> x
      modifyTVar' (lost q) (+ 1)

-- | Waits for a value.
pop :: Queue a -> STM a
pop q = do
  xs <- readTVar (items q)
  case Seq.viewl xs of
    EmptyL -> retry
    x :< rest -> writeTVar (items q) rest >> pure x

-- | Waits for a value, then takes all there are.
popAll :: Queue a -> STM [a]
popAll q = do
  xs <- readTVar (items q)
  check (not (Seq.null xs))
  writeTVar (items q) Seq.empty
  pure (toList xs)

isEmpty :: Queue a -> STM Bool
isEmpty q = Seq.null <$> readTVar (items q)

-- | How many values were forgotten since the start.
missed :: Queue a -> STM Int
missed = readTVar . lost
