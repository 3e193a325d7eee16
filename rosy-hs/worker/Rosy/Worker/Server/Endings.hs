{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Server.Endings
-- Description : Endings of children: for which limit they are killed, and what is reported of a run that has ended.
module Rosy.Worker.Server.Endings
  ( killExpired,
    enforceCeilings,
    finishRun,
    compileProblem,
  )
where

import Control.Monad (forM_)
import Data.Aeson (encode, object, (.=))
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, isNothing)
import Data.Sequence ((|>))
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Clock (getMonotonicTime)
import Rosy.Problem (tooMuchMemory)
import Rosy.Worker.CheckerPool
import Rosy.Worker.ChildProcess
import Rosy.Worker.MemoryCeiling (Activity (..), Usage (Usage), ceilings, compilingInterval, overdraft, runningInterval)
import Rosy.Worker.Preparations
import Rosy.Worker.Problem (Problem (..), problemNowhere)
import Rosy.Worker.Protocol
import Rosy.Worker.Sentence
import Rosy.Worker.Server.State
import Rosy.Worker.SharedMemory (activeFunctionName)
import Rosy.Worker.SystemCalls
import System.Posix.IO (closeFd)
import System.Posix.Process (getProcessID)
import System.Posix.Signals (sigKILL, signalProcess)

-- | Kills children that have used up their time.
killExpired :: State -> IO State
killExpired s = do
  now <- getMonotonicTime
  asked <- killOverdue now (pool s)
  reviewed <- Map.traverseWithKey (reviewJob now) (jobs s)
  let expired = [pid | (pid, job) <- Map.toList reviewed, isJust (overrun job)]
  pure s {pool = asked, jobs = reviewed, preparations = foldr withoutChild (preparations s) expired}
  where
    reviewJob now pid job = case budget job of
      Nothing -> pure job
      Just left -> do
        kept <- reviewChild now pid left
        case kept of
          Nothing -> job {budget = Nothing, overrun = Just TooLate} <$ signalProcess sigKILL (fromIntegral pid)
          Just _ -> pure job {budget = kept}

-- | Kills children so that all together stay below the ceilings of memory.
enforceCeilings :: Config -> State -> IO State
enforceCeilings config s = do
  now <- getMonotonicTime
  if not (isOccupied s) || now < nextLook s
    then pure s
    else do
      own <- getProcessID >>= anonymousMemory . fromIntegral
      let members = [(pid, activityOf job) | (pid, job) <- Map.toList (jobs s)] ++ [(pid, if works then Compiling else Running) | (pid, works) <- memberProcesses (pool s)]
          usage (pid, activity) = (\all' -> Usage pid activity (all' - min all' own)) <$> anonymousMemory pid
      victims <- overdraft (ceilings (memoryTotal config) (compileMemory (settings config))) <$> mapM usage members
      let isVictim pid = pid `elem` victims
          interval = if any isPreparing (jobs s) || any ((== Compiling) . snd) members then compilingInterval else runningInterval
      forM_ (filter isVictim (Map.keys (jobs s))) (signal sigKILL)
      asked <- killTooLarge victims (pool s)
      pure s {nextLook = now + interval, pool = asked, preparations = foldr withoutChild (preparations s) victims, jobs = Map.mapWithKey (\pid job -> if isVictim pid then job {budget = Nothing, overrun = Just TooLarge} else job) (jobs s)}

activityOf :: Job -> Activity
activityOf job
  | not (wanted job) = Prepared
  | isCompiling job = Compiling
  | otherwise = Running

-- | Reports the end of a run or of a forked worker.
finishRun :: Int -> ProcessEnd -> State -> IO State
finishRun pid how s = case Map.lookup pid (jobs s) of
  Nothing
    | Spare own channel shared <- spare s, own == pid -> s {spare = NotWanted} <$ (closeFd channel >> freeSharedPage shared)
    | Just i <- Map.lookup pid (workers s) -> pure (reply (RunEnded i (exitOrSignal how) Nothing Nothing) s {workers = Map.delete pid (workers s)})
    | otherwise -> pure s
  Just job -> do
    mapM_ closeFd (answers job)
    let rest = s {jobs = Map.delete pid (jobs s), preparations = withoutChild pid (preparations s)}
        i = jobId job
        wasKilled = how == Signalled 9 && isNothing (overrun job)
        gone = RunEnded i (exitOrSignal how)
    -- Copied once, because other processes may still write to the page.
    firing <- activeFunctionName <$> readSharedPage (page job)
    freeSharedPage (page job)
    case instead job of
      Just request | isNothing (overrun job) -> pure rest {waitingRuns = waitingRuns rest |> request}
      _ -> do
        closeInstead job
        pure (runEnd job i gone wasKilled firing rest)
  where
    runEnd job i gone wasKilled firing rest
      | started job = let atWork = if Text.null firing || isExit how then Nothing else Just firing in reply (gone atWork (endProblem job atWork how)) rest
      | not (wanted job) || answered job = rest
      | wasKilled = reply (gone Nothing Nothing) rest
      | otherwise = reply (Refused i (Lazy.toStrict (encode (object ["problems" .= [compileProblem (overrun job) (compilerFailure job) how]])))) rest
    endProblem job atWork ended
      | overrun job == Just TooLarge || outOfMemory ended = Just (memoryProblem atWork)
      | ended == Signalled cpuLimitSignal = Just timeProblem
      | otherwise = Nothing
    isExit (Exited n) = n /= heapOverflowExitCode
    isExit _ = False

exitOrSignal :: ProcessEnd -> Either Int Int
exitOrSignal how = case how of
  Exited n -> Left n
  Signalled n -> Right n

-- | The run-time system exits with a code of its own at its limit, and aborts at the kernel's limit.
outOfMemory :: ProcessEnd -> Bool
outOfMemory how = how `elem` [Exited heapOverflowExitCode, Signalled sigABRT']
  where
    sigABRT' = 6

-- | Signal at the CPU time limit (SIGXCPU).
cpuLimitSignal :: Int
cpuLimitSignal = 24

timeProblem :: Problem
timeProblem = problemNowhere "time" (tr "The program has computed for too long.") (tr "Press Run to start it again.")

-- | For a program that had no memory left to report it. Takes the active function.
memoryProblem :: Maybe Text -> Problem
memoryProblem atWork = (problemNowhere "memory" what why) {function = atWork}
  where
    (what, why) = tooMuchMemory (Text.unpack <$> atWork)

-- | Problem for a compilation that ended without an answer.
compileProblem :: Maybe Overrun -> Text -> ProcessEnd -> Problem
compileProblem exceeded words' how
  | exceeded == Just TooLate || how == Signalled cpuLimitSignal = problemNowhere "too-long" (tr "The program takes too long to check.") (tr "Make it shorter, or split large expressions into several functions.")
  | exceeded == Just TooLarge || outOfMemory how || refusedMemory = problemNowhere "too-large" (tr "The program takes too much memory to check.") (tr "Make it shorter, or split large expressions into several functions.")
  | otherwise = (problemNowhere "compiler" (tr "The program could not be checked.") (tr "Undo the last change and try again.")) {ghc = words'}
  where
    -- With GHC 9.6 the run-time system exits in this way when the kernel refuses memory that it has reserved (rts/posix/OSMem.c,
    -- @osCommitMemory@). A child that ends itself says why first ('runToExit').
    refusedMemory = how == Exited 1 && Text.null words'
