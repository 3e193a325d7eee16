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
import Control.Monad (foldM, forM_)
import Data.Aeson (Value (Null))
import qualified Data.ByteString as ByteString
import qualified Data.Map.Strict as Map
import Data.Sequence (Seq (..), (|>))
import qualified Data.Sequence as Seq
import qualified Data.Text as Text
import GHC.Clock (getMonotonicTime)
import Rosy.Worker.CheckerPool
import Rosy.Worker.ChildProcess
import Rosy.Worker.Ghc (Session)
import Rosy.Worker.LruCache
import Rosy.Worker.Preparations
import Rosy.Worker.Protocol
import Rosy.Worker.Server.Children
import Rosy.Worker.Server.Endings
import Rosy.Worker.Server.State
import Rosy.Worker.SystemCalls
import Rosy.Worker.TimeBudget
import System.Posix.IO (closeFd)
import System.Posix.Process (forkProcess)
import System.Posix.Signals (sigKILL)
import System.Posix.Types (Fd)

-- | Serves until the service closes its end; then all children are killed.
serve :: Config -> Session -> IO ()
serve config session = compactHeap >> serveCompacted config session

-- | The same in a process whose heap is compact already: a forked worker shares it with its parent.
serveCompacted :: Config -> Session -> IO ()
serveCompacted config session = do
  ended <- watchChildren
  loop config session ended newState

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
            s5 <- dispatchQuestions config session s4 >>= dispatchRuns config session >>= dispatchForks config session >>= dispatchPreparations config session >>= pausePreparations >>= dispatchSpare config session
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
    Bytes bytes descriptors -> do
      let (lines', rest) = splitLines (incoming s) bytes
      taken <- case descriptors of
        Nothing -> pure (pendingDescriptors s)
        Just found
          | Seq.length (pendingDescriptors s) >= maxPendingDescriptors -> pendingDescriptors s <$ closeLink found
          | otherwise -> pure (pendingDescriptors s |> found)
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
    Right (Run i order)
      | Just (preparation, others) <- takePreparation i (preparations s) -> beginPrepared config (RunRequest i order (link preparation)) (stage preparation) s {preparations = others}
    Right (Run i order) -> case pendingDescriptors s of
      Empty -> pure (reply (Failed i "A run needs the descriptor of its link.") s)
      found :<| others -> pure s {pendingDescriptors = others, waitingRuns = waitingRuns s |> RunRequest i order found}
    Right (Prepare i order) -> case pendingDescriptors s of
      Empty -> pure (reply (Failed i "A run needs the descriptor of its link.") s)
      found :<| others -> case addPreparation (Preparation i found (Queued order)) (preparations s) of
        Left sentence -> reply (Failed i (Text.pack sentence)) s {pendingDescriptors = others} <$ closeLink found
        Right more -> pure s {pendingDescriptors = others, preparations = more}
    Right (Fork i) -> case pendingDescriptors s of
      Empty -> pure (reply (Failed i "A forked worker needs the descriptor of its socket.") s)
      found :<| others -> do
        mapM_ closeFd (linkMailbox found)
        pure s {pendingDescriptors = others, waitingForks = waitingForks s |> ForkRequest i (linkSocket found)}
    Right (Kill i) -> kill i s
    Right (Ping i) -> pure (reply (Pong i) s)

dropPassenger :: State -> IO State
dropPassenger s = case pendingDescriptors s of
  Empty -> pure s
  found :<| others -> s {pendingDescriptors = others} <$ closeLink found

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
    closeLink (link preparation)
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
      (droppedRuns, keptRuns) = Seq.partition (\(RunRequest j _ _) -> j == i) (waitingRuns s)
  forM_ droppedRuns (\(RunRequest _ _ dropped') -> closeLink dropped')
  let ends = length dropped + length droppedRuns
  pure (foldr (\_ -> reply (RunEnded i (Right 9) Nothing Nothing)) s {waiting = kept, waitingRuns = keptRuns, jobs = Map.map (\job -> if jobId job == i then job {instead = Nothing} else job) (jobs s)} [1 .. ends])

-- * Children

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

reapChildren :: State -> IO State
reapChildren s = do
  one <- reapChild
  case one of
    Nothing -> pure s
    Just (pid, how) -> do
      -- Output written before the exit may still be unread.
      s' <- maybe (pure s) (\fd -> receiveFromRun fd pid s) (answers =<< Map.lookup pid (jobs s))
      (results, after) <- removeExited pid how (pool s')
      foldM (flip report) s' {pool = after} results >>= finishRun pid how >>= reapChildren
