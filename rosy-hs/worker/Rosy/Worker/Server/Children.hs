{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Server.Children
-- Description : Children of the worker that check and run programs: when they are forked, and what they say.
module Rosy.Worker.Server.Children
  ( -- * Forking
    dispatchQuestions,
    dispatchRuns,
    dispatchPreparations,
    dispatchSpare,
    pausePreparations,
    beginPrepared,

    -- * Hearing
    serveChecker,
    receiveFromRun,
    report,
  )
where

import Control.Exception (evaluate)
import Control.Monad (foldM, forM_, when)
import Data.Aeson (pairs)
import Data.Aeson.Encoding (encodingToLazyByteString)
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Sequence (Seq (..), (|>))
import Data.Text.Encoding (decodeUtf8With)
import Data.Text.Encoding.Error (lenientDecode)
import GHC.Clock (getMonotonicTime)
import Rosy.Worker.CheckerPool
import Rosy.Worker.ChildProcess
import Rosy.Worker.Ghc (Session)
import Rosy.Worker.LruCache
import Rosy.Worker.Preparations
import Rosy.Worker.Problem (Completion (..))
import Rosy.Worker.Protocol
import Rosy.Worker.Report (emptyReport)
import Rosy.Worker.Server.Endings
import Rosy.Worker.Server.State
import Rosy.Worker.SystemCalls
import Rosy.Worker.TimeBudget
import System.Posix.IO (closeFd)
import System.Posix.Process (forkProcess)
import System.Posix.Signals (sigCONT, sigKILL, sigSTOP)
import System.Posix.Types (Fd)

-- | Assigns waiting questions while there are free slots.
dispatchQuestions :: Config -> Session -> State -> IO State
dispatchQuestions config session s
  | (i, question) :<| others <- waiting s,
    hasFreeSlot (maxConcurrentChecks config) (pool s) = do
    now <- getMonotonicTime
    asked <- assignQuestion newChecker (newBudget (compileSeconds config) now) i question (pool s)
    dispatchQuestions config session s {waiting = others, pool = asked}
  | otherwise = pure s
  where
    newChecker = do
      (mine, theirs) <- newSocketPair
      pid <- forkProcess (runChecker (settings config) session theirs)
      closeFd theirs
      pure (fromIntegral pid, mine)

-- | Reads from and writes to a checker whose channel is ready.
serveChecker :: State -> (Int, (Bool, Bool)) -> IO State
serveChecker s (pid, (canRead, canWrite)) = do
  flushed <- if canWrite then flushQuestion pid (pool s) else pure (pool s)
  (results, after) <- if canRead then receiveAnswers pid flushed else pure ([], flushed)
  foldM (flip report) s {pool = after} results

-- | Sends the result of a question to the service.
report :: CheckResult -> State -> IO State
report result s = case result of
  CheckAnswered i question fields -> cacheAnswer question fields (reply (QuestionAnswered question i fields) s)
  CheckerCrashed i _ (Signalled 9) Nothing _ -> pure (reply (RunEnded i (Right 9) Nothing Nothing) s)
  CheckerCrashed i question how exceeded words' -> pure (reply (QuestionAnswered question i (fieldsOf question (compileProblem exceeded words' how))) s)
  where
    fieldsOf question p = Lazy.toStrict . encodingToLazyByteString . pairs $ case question of
      Check _ -> reportFields (emptyReport [p])
      Complete _ _ -> completionFields (Completion Nothing [])

-- | Starts waiting runs while few enough compile. A page has at most one, so pages take turns.
dispatchRuns :: Config -> Session -> State -> IO State
dispatchRuns config session s
  | RunRequest i order link :<| others <- waitingRuns s,
    length (filter isCompiling (Map.elems (jobs s))) < maxConcurrentChecks config =
    startRun config session i order link s {waitingRuns = others} >>= dispatchRuns config session
  | otherwise = pure s

startRun :: Config -> Session -> Id -> Order -> Link -> State -> IO State
startRun config session i order link s = do
  (taken, s') <- if isPlain order then takeSpare order link s else pure (Nothing, s)
  begun <- case taken of
    Just (pid, channel, shared) -> addJob config InSpare i pid channel shared s'
    Nothing -> snd <$> forkRun config session AtOnce i order link s'
  begun <$ closeLink link

-- | Gives an order to the spare child, if there is one that takes it at once; another is wanted then.
takeSpare :: Order -> Link -> State -> IO (Maybe (Int, Fd, SharedPage), State)
takeSpare order link s = case spare s of
  Spare pid channel shared -> do
    sent <- sendWithLink channel (orderLine order) link
    if sent
      then pure (Just (pid, channel, shared), s {spare = Missing})
      else (Nothing, s {spare = Missing}) <$ (signal sigKILL pid >> closeFd channel >> freeSharedPage shared)
  _ -> pure (Nothing, s {spare = Missing})

-- | Forks the child for the next plain run while nothing is computed.
dispatchSpare :: Config -> Session -> State -> IO State
dispatchSpare config session s
  | Missing <- spare s,
    not (isOccupied s) = do
    (pid, channel, shared) <- forkChild (runNextProgram (settings config) session)
    pure s {spare = Spare pid channel shared}
  | otherwise = pure s

-- | A child that compiles and runs a program.
forkRun :: Config -> Session -> Beginning -> Id -> Order -> Link -> State -> IO (Int, State)
forkRun config session beginning i order link s = do
  (pid, channel, shared) <- forkChild (\channel shared -> runProgram (settings config) session beginning channel link shared order)
  (,) pid <$> addJob config beginning i pid channel shared s

-- | A child with its channel and the page that it shares.
forkChild :: (Fd -> SharedPage -> IO ()) -> IO (Int, Fd, SharedPage)
forkChild life = do
  (mine, theirs) <- newSocketPair
  shared <- newSharedPage
  pid <- forkProcess (life theirs shared)
  unmapInChildren shared
  closeFd theirs
  pure (fromIntegral pid, mine, shared)

-- | The child with this process id has this run.
addJob :: Config -> Beginning -> Id -> Int -> Fd -> SharedPage -> State -> IO State
addJob config beginning i pid channel shared s = do
  now <- getMonotonicTime
  let job =
        Job
          { jobId = i,
            wanted = beginning /= WhenAsked,
            ready = False,
            paused = False,
            instead = Nothing,
            page = shared,
            started = False,
            answers = Just channel,
            inputBuffer = emptyLineBuffer,
            budget = Just (newBudget (compileSeconds config) now 0),
            answered = False,
            overrun = Nothing,
            compilerFailure = ""
          }
  pure s {jobs = Map.insert pid job (jobs s)}

-- | Compiles a program that may be run, one at a time, while there is nothing else to do.
dispatchPreparations :: Config -> Session -> State -> IO State
dispatchPreparations config session s
  | Just (i, link, order) <- nextPreparation (preparations s),
    not (isBusy s),
    not (any isPreparing (jobs s)) = do
    (pid, begun) <- forkRun config session WhenAsked i order link s
    pure begun {preparations = withChild i pid (preparations begun)}
  | otherwise = pure s

-- | Stops what compiles only in case while there is something else to do: it takes no time and no memory from checks and runs.
pausePreparations :: State -> IO State
pausePreparations s = do
  forM_ changed (\(pid, _) -> signal (if busy then sigSTOP else sigCONT) pid)
  pure s {jobs = foldr (\(pid, job) -> Map.insert pid job {paused = busy}) (jobs s) changed}
  where
    busy = isBusy s
    changed = [(pid, job) | (pid, job) <- Map.toList (jobs s), isPreparing job, paused job /= busy]

-- | Lets a prepared program begin, or compiles it now where there is none. It may take as long to compile as any other from now on.
beginPrepared :: Config -> RunRequest -> Stage -> State -> IO State
beginPrepared config request what s = case what of
  Child pid
    | Just job@Job {answers = Just fd} <- Map.lookup pid (jobs s) -> do
      -- One byte always fits; a child that has died is noticed when it is reaped.
      _ <- send fd "\n"
      when (paused job) (signal sigCONT pid)
      now <- getMonotonicTime
      computed <- fromMaybe 0 <$> processorTime pid
      pure s {jobs = Map.insert pid job {wanted = True, paused = False, instead = Just request, budget = Just (newBudget (compileSeconds config) now computed)} (jobs s)}
  _ -> pure s {waitingRuns = waitingRuns s |> request}

-- | Reads the output of a run.
receiveFromRun :: Fd -> Int -> State -> IO State
receiveFromRun fd pid s = case Map.lookup pid (jobs s) of
  Nothing -> pure s
  Just job -> do
    got <- receive fd
    case got of
      WouldBlock -> pure s
      Closed -> s {jobs = Map.insert pid job {answers = Nothing} (jobs s)} <$ closeFd fd
      Bytes bytes descriptors -> do
        mapM_ closeLink descriptors
        let (found, rest) = splitLines (inputBuffer job) bytes
            s' = s {jobs = Map.insert pid job {inputBuffer = rest} (jobs s)}
        foldM (flip (handleRunLine pid)) s' found >>= receiveFromRun fd pid

-- | Handles one line of a child. Only the first answer counts: afterwards the program itself may write to the descriptor.
handleRunLine :: Int -> BufferedLine -> State -> IO State
handleRunLine pid (Line bytes) s
  | Just job <- Map.lookup pid (jobs s),
    not (answered job) =
    let keep changed = pure s {jobs = Map.insert pid changed (jobs s)}
        done answer runs = do
          closeInstead job
          reply answer <$> keep job {answered = True, budget = Nothing, started = runs, instead = Nothing}
     in case Char8.uncons bytes of
          Just ('P', _) -> keep job {ready = True, budget = if wanted job then budget job else Nothing}
          -- The run is compiled again when it is asked for, and refused then.
          Just ('R', _) | not (wanted job) -> pure s {preparations = withoutChild pid (preparations s)}
          Just ('S', fields) -> done (Started (jobId job) fields) True
          Just ('R', fields) -> done (Refused (jobId job) fields) False
          Just ('!', words') -> keep job {compilerFailure = decodeUtf8With lenientDecode words'}
          _ -> pure s
handleRunLine _ _ s = pure s

-- | Adds an answer to the cache.
cacheAnswer :: Question -> ByteString -> State -> IO State
cacheAnswer question fields s = do
  asked <- copyOffHeap (questionBytes question)
  known <- copyOffHeap fields
  (gone, after) <- evaluate (insertEntry cacheBytes asked (ByteString.length asked + ByteString.length known) known (cache s))
  forM_ gone (\(k, v) -> freeOffHeap k >> freeOffHeap v)
  pure s {cache = after}

-- | Size of the cache, bytes: enough for a class in which each learner alternates between a dozen programs.
cacheBytes :: Int
cacheBytes = 4 * 1024 * 1024
