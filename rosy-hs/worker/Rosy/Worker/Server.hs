{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Server
-- Description : Event loop of the worker: relays between the service and forked children.
--
-- Waits in one poll for requests, answers of children and their exits. It compiles nothing itself and runs no learner's code, so no
-- program can harm it; every child is reaped. A child can also be another worker, which shares the memory of this one.
module Rosy.Worker.Server
  ( Config (..),
    serve,
  )
where

import Control.Exception (evaluate)
import Control.Monad (foldM, forM_, when)
import Data.Aeson (Value (Null), encode, object, pairs, (.=))
import Data.Aeson.Encoding (encodingToLazyByteString)
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, isNothing)
import Data.Sequence (Seq (..), (|>))
import qualified Data.Sequence as Seq
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8With)
import Data.Text.Encoding.Error (lenientDecode)
import Data.Word (Word64)
import GHC.Clock (getMonotonicTime)
import Rosy.Problem (tooMuchMemory)
import Rosy.Worker.CheckerPool
import Rosy.Worker.ChildProcess
import Rosy.Worker.Ghc (Session, compilerVersion)
import Rosy.Worker.LruCache
import Rosy.Worker.MemoryCeiling (Activity (..), Usage (Usage), ceilings, compilingInterval, overdraft, runningInterval)
import Rosy.Worker.Preparations
import Rosy.Worker.Problem (Completion (..), Problem (..), problemNowhere)
import Rosy.Worker.Protocol
import Rosy.Worker.Report (emptyReport)
import Rosy.Worker.Sentence
import Rosy.Worker.SharedMemory (activeFunctionName)
import Rosy.Worker.SystemCalls
import Rosy.Worker.TimeBudget
import System.Posix.IO (closeFd)
import System.Posix.Process (forkProcess, getProcessID)
import System.Posix.Signals (Signal, sigCONT, sigKILL, sigSTOP, signalProcess)
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

-- | A run that waits for others to be compiled: id, source, bytes of memory, link.
data RunRequest = RunRequest Id Text Int Fd

-- | A worker to be forked: id, socket.
data ForkRequest = ForkRequest Id Fd

data State = State
  { incoming :: LineBuffer,
    -- | Received descriptors whose run request has not arrived yet.
    pendingDescriptors :: Seq Fd,
    outgoing :: Seq ByteString,
    -- | By process id.
    jobs :: Map.Map Int Job,
    pool :: CheckerPool,
    -- | Questions that are not assigned yet.
    waiting :: Seq (Id, Question),
    -- | Runs whose compilation has not begun.
    waitingRuns :: Seq RunRequest,
    preparations :: Preparations,
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

-- | Serves until the service closes its end; then all children are killed.
serve :: Config -> Session -> IO ()
serve config session = compactHeap >> serveCompacted config session

-- | The same in a process whose heap is compact already: a forked worker shares it with its parent.
serveCompacted :: Config -> Session -> IO ()
serveCompacted config session = do
  ended <- watchChildren
  let begun = State emptyLineBuffer Seq.empty (Seq.singleton (answerLine (Ready compilerVersion))) Map.empty emptyPool Seq.empty Seq.empty noPreparations Seq.empty Map.empty 0 emptyCache False
  loop config session ended begun

loop :: Config -> Session -> Fd -> State -> IO ()
loop config session ended = go
  where
    go s
      | peerGone s = forM_ (Map.keys (jobs s) ++ map fst (pollDescriptors (pool s)) ++ Map.keys (workers s)) (signal sigKILL)
      | otherwise = do
        now <- getMonotonicTime
        let listening = [(fd, pid) | (pid, Job {answers = Just fd}) <- Map.toList (jobs s)]
            asking = pollDescriptors (pool s)
            look = [nextLook s | isOccupied s]
            next = minimum (60 : map (subtract now) (look ++ pendingReviews (pool s) ++ [nextReview t | Job {budget = Just t} <- Map.elems (jobs s)]))
        ready <-
          poll
            ((socket config, if Seq.null (outgoing s) then Readable else ReadableOrWritable) : (ended, Readable) : [(fd, Readable) | (fd, _) <- listening] ++ map snd asking)
            (max 0 (ceiling (next * 1000)))
        case ready of
          (mine, canWrite) : (reaping, _) : others -> do
            let (children, askers) = splitAt (length listening) others
            s0 <- foldM serveChecker s (zip (map fst asking) askers)
            s1 <- foldM (\st ((fd, pid), (yes, _)) -> if yes then receiveFromRun fd pid st else pure st) s0 (zip listening children)
            s2 <- if reaping then drain ended >> reapChildren s1 else pure s1
            s3 <- killExpired s2 >>= enforceCeilings config
            s4 <- if mine then receiveRequests config s3 else pure s3
            s5 <- dispatchQuestions config session s4 >>= dispatchRuns config session >>= dispatchForks config session >>= dispatchPreparations config session >>= pausePreparations
            s6 <- if canWrite || not (Seq.null (outgoing s5)) then flush config s5 else pure s5
            go s6
          _ -> go s

-- * Requests

receiveRequests :: Config -> State -> IO State
receiveRequests config s = do
  got <- receive (socket config)
  case got of
    WouldBlock -> pure s
    Closed -> pure s {peerGone = True}
    Bytes bytes descriptor -> do
      let (lines', rest) = splitLines (incoming s) bytes
      taken <- case descriptor of
        Nothing -> pure (pendingDescriptors s)
        Just fd
          | Seq.length (pendingDescriptors s) >= maxPendingDescriptors -> pendingDescriptors s <$ closeFd fd
          | otherwise -> pure (pendingDescriptors s |> fd)
      foldM (handle config) s {incoming = rest, pendingDescriptors = taken} lines'

-- | Maximal number of descriptors that wait for their run request.
maxPendingDescriptors :: Int
maxPendingDescriptors = 64

handle :: Config -> State -> BufferedLine -> IO State
handle _ s TooLong = pure (reply (Failed Null "This line is too long.") s)
handle config s (Line bytes)
  | ByteString.null bytes = pure s
  | otherwise = case parseRequest bytes of
    Left (i, sentence) -> do
      -- An invalid request has still sent its descriptor.
      s' <- if any (`ByteString.isInfixOf` bytes) ["\"run\"", "\"prepare\"", "\"fork\""] then dropPassenger s else pure s
      pure (reply (Failed i sentence) s')
    Right (Ask i question) -> case lookupEntry (questionBytes question) (cache s) of
      Just (fields, after) -> do
        -- The cached bytes may be freed before this has been sent.
        own <- evaluate (ByteString.copy fields)
        pure (reply (QuestionAnswered question i own) s {cache = after})
      Nothing -> pure s {waiting = waiting s |> (i, question)}
    Right (Run i source memory)
      | Just (preparation, others) <- takePreparation i (preparations s) -> beginPrepared config (RunRequest i source memory (link preparation)) (stage preparation) s {preparations = others}
    Right (Run i source memory) -> case pendingDescriptors s of
      Empty -> pure (reply (Failed i "A run needs the descriptor of its link.") s)
      fd :<| others -> pure s {pendingDescriptors = others, waitingRuns = waitingRuns s |> RunRequest i source memory fd}
    Right (Prepare i source memory) -> case pendingDescriptors s of
      Empty -> pure (reply (Failed i "A run needs the descriptor of its link.") s)
      fd :<| others -> case addPreparation (Preparation i fd (Queued source memory)) (preparations s) of
        Left sentence -> reply (Failed i (Text.pack sentence)) s {pendingDescriptors = others} <$ closeFd fd
        Right more -> pure s {pendingDescriptors = others, preparations = more}
    Right (Fork i) -> case pendingDescriptors s of
      Empty -> pure (reply (Failed i "A forked worker needs the descriptor of its socket.") s)
      fd :<| others -> pure s {pendingDescriptors = others, waitingForks = waitingForks s |> ForkRequest i fd}
    Right (Kill i) -> kill i s
    Right (Ping i) -> pure (reply (Pong i) s)

dropPassenger :: State -> IO State
dropPassenger s = case pendingDescriptors s of
  Empty -> pure s
  fd :<| others -> s {pendingDescriptors = others} <$ closeFd fd

reply :: Answer -> State -> State
reply answer s = s {outgoing = outgoing s |> answerLine answer}

flush :: Config -> State -> IO State
flush config s = case outgoing s of
  Empty -> pure s
  first :<| rest -> do
    sent <- send (socket config) first
    case sent of
      PeerClosed -> pure s {peerGone = True}
      Sent n
        | n == ByteString.length first -> flush config s {outgoing = rest}
        | otherwise -> pure s {outgoing = ByteString.drop n first :<| rest}

kill :: Id -> State -> IO State
kill i s
  | Just (preparation, others) <- takePreparation i (preparations s) = do
    closeFd (link preparation)
    let dropped = s {preparations = others}
    case stage preparation of
      -- Its end is told when it has been reaped, as that of a run.
      Child pid -> dropped {jobs = Map.adjust (\job -> job {wanted = True}) pid (jobs s)} <$ signal sigKILL pid
      _ -> pure (reply (RunEnded i (Right 9) Nothing Nothing) dropped)
kill i s = do
  let mine = Map.filter ((== i) . jobId) (jobs s)
  forM_ (Map.keys mine ++ [pid | (pid, j) <- Map.toList (workers s), i == j]) (signal sigKILL)
  mapM_ closeInstead mine
  cancelQuestion i (pool s)
  let (dropped, kept) = Seq.partition ((== i) . fst) (waiting s)
      (droppedRuns, keptRuns) = Seq.partition (\(RunRequest j _ _ _) -> j == i) (waitingRuns s)
  forM_ droppedRuns (\(RunRequest _ _ _ link) -> closeFd link)
  let ends = length dropped + length droppedRuns
  pure (foldr (\_ -> reply (RunEnded i (Right 9) Nothing Nothing)) s {waiting = kept, waitingRuns = keptRuns, jobs = Map.map (\job -> if jobId job == i then job {instead = Nothing} else job) (jobs s)} [1 .. ends])

-- | Closes the link that is kept in case that a prepared child is lost.
closeInstead :: Job -> IO ()
closeInstead job = forM_ (instead job) (\(RunRequest _ _ _ fd) -> closeFd fd)

signal :: Signal -> Int -> IO ()
signal what pid = signalProcess what (fromIntegral pid)

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

-- * Children

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
  told <- if canWrite then flushQuestion pid (pool s) else pure (pool s)
  (said, after) <- if canRead then receiveAnswers pid told else pure ([], told)
  foldM (flip report) s {pool = after} said

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
  | RunRequest i source memory link :<| others <- waitingRuns s,
    length (filter isCompiling (Map.elems (jobs s))) < maxConcurrentChecks config =
    startRun config session i source memory link s {waitingRuns = others} >>= dispatchRuns config session
  | otherwise = pure s

-- | Whether a run that has been asked for is being compiled.
isCompiling :: Job -> Bool
isCompiling job = wanted job && not (answered job)

-- | Whether a program is compiled that may never be run.
isPreparing :: Job -> Bool
isPreparing job = not (wanted job || ready job)

startRun :: Config -> Session -> Id -> Text -> Int -> Fd -> State -> IO State
startRun config session i source memory fd s = do
  (_, begun) <- forkRun config session AtOnce i source memory fd s
  begun <$ closeFd fd

-- | A child that compiles and runs a program.
forkRun :: Config -> Session -> Beginning -> Id -> Text -> Int -> Fd -> State -> IO (Int, State)
forkRun config session beginning i source memory fd s = do
  (mine, theirs) <- newSocketPair
  shared <- newSharedPage
  pid <- fromIntegral <$> forkProcess (runProgram (settings config) session beginning theirs fd shared (fromIntegral (max 0 memory)) source)
  unmapInChildren shared
  closeFd theirs
  now <- getMonotonicTime
  let job =
        Job
          { jobId = i,
            wanted = beginning == AtOnce,
            ready = False,
            paused = False,
            instead = Nothing,
            page = shared,
            started = False,
            answers = Just mine,
            inputBuffer = emptyLineBuffer,
            budget = Just (newBudget (compileSeconds config) now 0),
            answered = False,
            overrun = Nothing,
            compilerFailure = ""
          }
  pure (pid, s {jobs = Map.insert pid job (jobs s)})

-- | Whether there is a question, or a run to compile.
isBusy :: State -> Bool
isBusy s = not (Seq.null (waiting s) && Seq.null (waitingRuns s)) || any snd (memberProcesses (pool s)) || any isCompiling (jobs s)

-- | Compiles a program that may be run, one at a time, while there is nothing else to do.
dispatchPreparations :: Config -> Session -> State -> IO State
dispatchPreparations config session s
  | Just (i, fd, source, memory) <- nextPreparation (preparations s),
    not (isBusy s),
    not (any isPreparing (jobs s)) = do
    (pid, begun) <- forkRun config session WhenAsked i source memory fd s
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

-- | Forks the workers that were asked for. Each shares this process's memory, also its session, and serves its own socket.
dispatchForks :: Config -> Session -> State -> IO State
dispatchForks config session s = case waitingForks s of
  Empty -> pure s
  ForkRequest i fd :<| others -> do
    pid <- forkProcess $ do
      becomeWorker [fd, nullFd (settings config)]
      serveCompacted config {socket = fd} session
    closeFd fd
    dispatchForks config session (reply (Forked i (fromIntegral pid)) s {waitingForks = others, workers = Map.insert (fromIntegral pid) i (workers s)})

-- | Reads the output of a run.
receiveFromRun :: Fd -> Int -> State -> IO State
receiveFromRun fd pid s = case Map.lookup pid (jobs s) of
  Nothing -> pure s
  Just job -> do
    got <- receive fd
    case got of
      WouldBlock -> pure s
      Closed -> s {jobs = Map.insert pid job {answers = Nothing} (jobs s)} <$ closeFd fd
      Bytes bytes descriptor -> do
        mapM_ closeFd descriptor
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

-- | Whether a child compiles or a program runs.
isOccupied :: State -> Bool
isOccupied s = any (\job -> wanted job || isPreparing job) (jobs s) || any snd (memberProcesses (pool s))

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

reapChildren :: State -> IO State
reapChildren s = do
  one <- reapChild
  case one of
    Nothing -> pure s
    Just (pid, how) -> do
      -- Output written before the exit may still be unread.
      s' <- maybe (pure s) (\fd -> receiveFromRun fd pid s) (answers =<< Map.lookup pid (jobs s))
      (said, after) <- removeExited pid how (pool s')
      foldM (flip report) s' {pool = after} said >>= finishRun pid how >>= reapChildren

-- | Reports the end of a run or of a forked worker.
finishRun :: Int -> ProcessEnd -> State -> IO State
finishRun pid how s = case Map.lookup pid (jobs s) of
  Nothing
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
        pure (told job i gone wasKilled firing rest)
  where
    told job i gone wasKilled firing rest
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
  | exceeded == Just TooLate = problemNowhere "too-long" (tr "The program takes too long to check.") (tr "Make it shorter, or split large expressions into several functions.")
  | exceeded == Just TooLarge || outOfMemory how || refusedMemory = problemNowhere "too-large" (tr "The program takes too much memory to check.") (tr "Make it shorter, or split large expressions into several functions.")
  | otherwise = (problemNowhere "compiler" (tr "The program could not be checked.") (tr "Undo the last change and try again.")) {ghc = words'}
  where
    -- With GHC 9.6 the run-time system exits in this way when the kernel refuses memory that it has reserved (rts/posix/OSMem.c,
    -- @osCommitMemory@). A child that ends itself says why first ('runToExit').
    refusedMemory = how == Exited 1 && Text.null words'
