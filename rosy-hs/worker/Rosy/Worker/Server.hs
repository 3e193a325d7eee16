{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Server
-- Description : The parent: one loop that relays between the service and the children it forks.
--
-- Waits in one place for the service, the children's answers and their ends. It compiles nothing itself and runs nothing
-- of a learner's, so no program can harm it; a child may die at any moment and is always reaped.
module Rosy.Worker.Server
  ( Config (..),
    serve,
  )
where

import Control.Exception (evaluate)
import Control.Monad (foldM, forM_)
import Data.Aeson (Value (Null), encode, object, pairs, (.=))
import Data.Aeson.Encoding (encodingToLazyByteString)
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Map.Strict as Map
import Data.Sequence (Seq (..), (|>))
import qualified Data.Sequence as Seq
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8With)
import Data.Text.Encoding.Error (lenientDecode)
import GHC.Clock (getMonotonicTime)
import Rosy.Problem (tooMuchMemory)
import Rosy.Worker.Checkers
import Rosy.Worker.Child
import Rosy.Worker.Ghc (Session, compilerVersion)
import Rosy.Worker.Page (wordOf)
import Rosy.Worker.Problem (Completion (..), Problem (..), emptyReport, problemNowhere)
import Rosy.Worker.Remember
import Rosy.Worker.Sys
import Rosy.Worker.Wire
import System.Mem (performMajorGC)
import System.Posix.IO (closeFd)
import System.Posix.Process (forkProcess)
import System.Posix.Signals (sigKILL, signalProcess)
import System.Posix.Types (Fd)

data Config = Config
  { socket :: Fd,
    settings :: Settings,
    -- | Wall-clock seconds that reading and checking a program may take.
    compileSeconds :: Double,
    checksAtOnce :: Int
  }

-- | A run.
data Job = Job
  { jobId :: Id,
    -- | The page with the function at work.
    page :: Page,
    -- | Whether the program has started.
    started :: Bool,
    -- | Until the child has closed it.
    answers :: Maybe Fd,
    heard :: Lines,
    -- | When compiling must be done; 'getMonotonicTime'.
    deadline :: Maybe Double,
    answered :: Bool,
    -- | Ended by the worker for taking too long.
    late :: Bool,
    -- | What the compiler said when it failed itself.
    lastWords :: Text
  }

data State = State
  { incoming :: Lines,
    -- | Descriptors that rode in, for the run lines to come.
    passengers :: Seq Fd,
    outgoing :: Seq ByteString,
    -- | By process id.
    jobs :: Map.Map Int Job,
    checkers :: Checkers,
    -- | Questions that nobody works on yet.
    waiting :: Seq (Id, Question),
    -- | By 'questionBytes'.
    cache :: Remembered ByteString ByteString,
    peerGone :: Bool
  }

-- | Serves until the service closes its end; then every child dies with this process.
serve :: Config -> Session -> IO ()
serve config session = do
  ended <- watchChildren
  performMajorGC
  let begun = State noLines Seq.empty (Seq.singleton (answerLine (ReadyNow compilerVersion))) Map.empty noCheckers Seq.empty nothingYet False
  loop config session ended begun

loop :: Config -> Session -> Fd -> State -> IO ()
loop config session ended = go
  where
    go s
      | peerGone s = forM_ (Map.keys (jobs s) ++ map fst (ears (checkers s))) (signalProcess sigKILL . fromIntegral)
      | otherwise = do
        now <- getMonotonicTime
        let listening = [(fd, pid) | (pid, Job {answers = Just fd}) <- Map.toList (jobs s)]
            asking = ears (checkers s)
            next = minimum (60 : map (subtract now) (nextDeadline (checkers s) ++ [t | Job {deadline = Just t} <- Map.elems (jobs s)]))
        ready <-
          poll
            ((socket config, if Seq.null (outgoing s) then ToRead else ToWriteOrRead) : (ended, ToRead) : [(fd, ToRead) | (fd, _) <- listening] ++ map snd asking)
            (max 0 (ceiling (next * 1000)))
        case ready of
          (mine, canWrite) : (reaping, _) : others -> do
            let (children, askers) = splitAt (length listening) others
            s0 <- foldM attend s (zip (map fst asking) askers)
            s1 <- foldM (\st ((fd, pid), (yes, _)) -> if yes then hear fd pid st else pure st) s0 (zip listening children)
            s2 <- if reaping then drain ended >> reapAll s1 else pure s1
            s3 <- expire s2
            s4 <- if mine then listen config session s3 else pure s3
            s5 <- beginAnswers config session s4
            s6 <- if canWrite || not (Seq.null (outgoing s5)) then flush config s5 else pure s5
            go s6
          _ -> go s

-- * The service

listen :: Config -> Session -> State -> IO State
listen config session s = do
  got <- receive (socket config)
  case got of
    NothingYet -> pure s
    Closed -> pure s {peerGone = True}
    Bytes bytes passenger -> do
      let (lines', rest) = cut (incoming s) bytes
      taken <- case passenger of
        Nothing -> pure (passengers s)
        Just fd
          | Seq.length (passengers s) >= mostPassengers -> passengers s <$ closeFd fd
          | otherwise -> pure (passengers s |> fd)
      foldM (handle config session) s {incoming = rest, passengers = taken} lines'

-- | Descriptors that may wait for their run line.
mostPassengers :: Int
mostPassengers = 64

handle :: Config -> Session -> State -> Cut -> IO State
handle _ _ s TooLong = pure (reply (Failed Null "This line is too long.") s)
handle config session s (Line bytes)
  | ByteString.null bytes = pure s
  | otherwise = case parseRequest bytes of
    Left (i, sentence) -> do
      -- A run that cannot be read still brought its descriptor.
      s' <- if "\"run\"" `ByteString.isInfixOf` bytes then dropPassenger s else pure s
      pure (reply (Failed i sentence) s')
    Right (Ask i question) -> case recall (questionBytes question) (cache s) of
      Just (fields, after) -> do
        -- The remembered bytes may be given back before this has been sent.
        own <- evaluate (ByteString.copy fields)
        pure (reply (Known question i own) s {cache = after})
      Nothing -> pure s {waiting = waiting s |> (i, question)}
    Right (Run i source memory) -> case passengers s of
      Empty -> pure (reply (Failed i "A run needs the descriptor of its link.") s)
      fd :<| others -> startRun config session i source memory fd s {passengers = others}
    Right (Kill i) -> kill i s
    Right (Ping i) -> pure (reply (Pong i) s)

dropPassenger :: State -> IO State
dropPassenger s = case passengers s of
  Empty -> pure s
  fd :<| others -> s {passengers = others} <$ closeFd fd

reply :: Answer -> State -> State
reply answer s = s {outgoing = outgoing s |> answerLine answer}

flush :: Config -> State -> IO State
flush config s = case outgoing s of
  Empty -> pure s
  first :<| rest -> do
    sent <- send (socket config) first
    case sent of
      Gone -> pure s {peerGone = True}
      Sent n
        | n == ByteString.length first -> flush config s {outgoing = rest}
        | otherwise -> pure s {outgoing = ByteString.drop n first :<| rest}

kill :: Id -> State -> IO State
kill i s = do
  forM_ [pid | (pid, job) <- Map.toList (jobs s), jobId job == i] (signalProcess sigKILL . fromIntegral)
  stopAsking i (checkers s)
  let (dropped, kept) = Seq.partition ((== i) . fst) (waiting s)
  pure (foldr (\_ -> reply (GoneNow i (Right 9) Nothing Nothing)) s {waiting = kept} dropped)

-- * Children

-- | Begins with the questions for which there is room.
beginAnswers :: Config -> Session -> State -> IO State
beginAnswers config session s
  | (i, question) :<| others <- waiting s,
    hasRoom (checksAtOnce config) (checkers s) = do
    now <- getMonotonicTime
    asked <- askOne newChecker (now + compileSeconds config) i question (checkers s)
    beginAnswers config session s {waiting = others, checkers = asked}
  | otherwise = pure s
  where
    newChecker = do
      (mine, theirs) <- newPair
      pid <- forkProcess (answerChild (settings config) session theirs)
      closeFd theirs
      pure (fromIntegral pid, mine)

-- | Serves a checker that is ready to be heard or told more.
attend :: State -> (Int, (Bool, Bool)) -> IO State
attend s (pid, (canRead, canWrite)) = do
  told <- if canWrite then sendMore pid (checkers s) else pure (checkers s)
  (said, after) <- if canRead then listenTo pid told else pure ([], told)
  foldM (flip report) s {checkers = after} said

-- | Passes on what became of a question.
report :: Heard -> State -> IO State
report heard' s = case heard' of
  Answered i question fields -> keepAnswer question fields (reply (Known question i fields) s)
  Broken i _ (Signalled 9) False _ -> pure (reply (GoneNow i (Right 9) Nothing Nothing) s)
  Broken i question how tooLate words' -> pure (reply (Known question i (fieldsOf question (compileProblem tooLate words' how))) s)
  where
    fieldsOf question p = Lazy.toStrict . encodingToLazyByteString . pairs $ case question of
      Check _ -> reportFields (emptyReport [p])
      Complete _ _ -> completionFields (Completion Nothing [])

startRun :: Config -> Session -> Id -> Text -> Int -> Fd -> State -> IO State
startRun config session i source memory link s = do
  (mine, theirs) <- newPair
  shared <- newPage
  pid <- forkProcess (runChild (settings config) session theirs link shared (fromIntegral (max 0 memory)) source)
  keepPage shared
  closeFd theirs
  closeFd link
  now <- getMonotonicTime
  pure s {jobs = Map.insert (fromIntegral pid) (Job i shared False (Just mine) noLines (Just (now + compileSeconds config)) False False "") (jobs s)}

-- | Takes what a child has to say.
hear :: Fd -> Int -> State -> IO State
hear fd pid s = case Map.lookup pid (jobs s) of
  Nothing -> pure s
  Just job -> do
    got <- receive fd
    case got of
      NothingYet -> pure s
      Closed -> s {jobs = Map.insert pid job {answers = Nothing} (jobs s)} <$ closeFd fd
      Bytes bytes passenger -> do
        mapM_ closeFd passenger
        let (found, rest) = cut (heard job) bytes
            s' = s {jobs = Map.insert pid job {heard = rest} (jobs s)}
        hear fd pid (foldl (flip (understand pid)) s' found)

-- | One line of a child. Only the first counts: a program may have got hold of the descriptor by then.
understand :: Int -> Cut -> State -> State
understand pid (Line bytes) s
  | Just job <- Map.lookup pid (jobs s),
    not (answered job) =
    let done answer runs = reply answer s {jobs = Map.insert pid job {answered = True, deadline = Nothing, started = runs} (jobs s)}
     in case Char8.uncons bytes of
          Just ('S', fields) -> done (Started (jobId job) fields) True
          Just ('R', fields) -> done (Refused (jobId job) fields) False
          Just ('!', words') -> s {jobs = Map.insert pid job {lastWords = decodeUtf8With lenientDecode words'} (jobs s)}
          _ -> s
understand _ _ s = s

-- | Keeps an answer for those who ask again.
keepAnswer :: Question -> ByteString -> State -> IO State
keepAnswer question fields s = do
  asked <- outside (questionBytes question)
  known <- outside fields
  (gone, after) <- evaluate (remember mostRemembered asked (ByteString.length asked + ByteString.length known) known (cache s))
  forM_ gone (\(k, v) -> giveBack k >> giveBack v)
  pure s {cache = after}

-- | Bytes of questions and answers that are kept for those who ask again: those of a class that each go back and forth between a dozen
-- programs.
mostRemembered :: Int
mostRemembered = 4 * 1024 * 1024

-- | Ends what compiles for too long.
expire :: State -> IO State
expire s = do
  now <- getMonotonicTime
  let over job = maybe False (<= now) (deadline job)
  forM_ [pid | (pid, job) <- Map.toList (jobs s), over job] (signalProcess sigKILL . fromIntegral)
  asked <- overdue now (checkers s)
  pure s {checkers = asked, jobs = Map.map (\job -> if over job then job {deadline = Nothing, late = True} else job) (jobs s)}

reapAll :: State -> IO State
reapAll s = do
  one <- reap
  case one of
    Nothing -> pure s
    Just (pid, how) -> do
      -- What it said before it ended may still be on its way.
      s' <- maybe (pure s) (\fd -> hear fd pid s) (answers =<< Map.lookup pid (jobs s))
      (said, after) <- buried pid how (checkers s')
      foldM (flip report) s' {checkers = after} said >>= bury pid how >>= reapAll

-- | The last word about a child.
bury :: Int -> Ended -> State -> IO State
bury pid how s = case Map.lookup pid (jobs s) of
  Nothing -> pure s
  Just job -> do
    mapM_ closeFd (answers job)
    let rest = s {jobs = Map.delete pid (jobs s)}
        i = jobId job
        wasKilled = how == Signalled 9 && not (late job)
        gone = GoneNow i (case how of Exited n -> Left n; Signalled n -> Right n)
    -- Copied once: what is looked at below changes no more, whoever writes.
    firing <- wordOf <$> pageBytes (page job)
    freePage (page job)
    pure $
      if started job
        then let atWork = if Text.null firing || isExit how then Nothing else Just firing in reply (gone atWork (endedBy atWork how)) rest
        else
          if answered job
            then rest
            else
              if wasKilled
                then reply (gone Nothing Nothing) rest
                else reply (Refused i (Lazy.toStrict (encode (object ["problems" .= [compileProblem (late job) (lastWords job) how]])))) rest
  where
    endedBy atWork ended
      | outOfMemory ended = Just (memoryProblem atWork)
      | ended == Signalled tookTooLong = Just timeProblem
      | otherwise = Nothing
    isExit (Exited n) = n /= ranOutOfMemory
    isExit _ = False

-- | The run-time system leaves with a code of its own when its limit is reached, and aborts when the kernel's is.
outOfMemory :: Ended -> Bool
outOfMemory how = how `elem` [Exited ranOutOfMemory, Signalled sigABRT']
  where
    sigABRT' = 6

-- | The signal of a process that has computed for longer than it may (SIGXCPU).
tookTooLong :: Int
tookTooLong = 24

timeProblem :: Problem
timeProblem = problemNowhere "time" "The program has computed for too long." "Press Run to start it again."

-- | For a program that has no memory left to say it itself. Takes the function at work.
memoryProblem :: Maybe Text -> Problem
memoryProblem atWork = (problemNowhere "memory" (Text.pack message) (Text.pack hint)) {function = atWork}
  where
    (message, hint) = tooMuchMemory (Text.unpack <$> atWork)

-- | Why a compilation ended without an answer.
compileProblem :: Bool -> Text -> Ended -> Problem
compileProblem tooLate words' how
  | tooLate = problemNowhere "too-long" "The program takes too long to check." "Make it shorter, or split large expressions into several functions."
  | outOfMemory how = problemNowhere "too-large" "The program takes too much memory to check." "Make it shorter, or split large expressions into several functions."
  | otherwise = (problemNowhere "compiler" "The program could not be checked." "Undo the last change and try again.") {ghc = words'}
