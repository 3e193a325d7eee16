{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.CheckerPool
-- Description : Pool of child processes; each answers one question about a program at a time.
--
-- Forking a child for each question would take as long as answering it, so children are reused for a number of questions. They never
-- run a program. A child that crashes is replaced; its question is answered with the way the child ended.
module Rosy.Worker.CheckerPool
  ( CheckerPool,
    emptyPool,
    CheckResult (..),
    Overrun (..),

    -- * Questions
    hasFreeSlot,
    assignQuestion,
    cancelQuestion,

    -- * Events
    pollDescriptors,
    receiveAnswers,
    flushQuestion,
    killOverdue,
    killTooLarge,
    memberProcesses,
    removeExited,
    pendingReviews,
    reviewChild,
  )
where

import Control.Monad (forM_)
import Data.Aeson (encode, object, (.=))
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isNothing)
import Data.Text (Text)
import Data.Text.Encoding (decodeUtf8With)
import Data.Text.Encoding.Error (lenientDecode)
import Rosy.Worker.Problem (Position (..))
import Rosy.Worker.Protocol
import Rosy.Worker.SystemCalls
import Rosy.Worker.TimeBudget
import System.Posix.IO (closeFd)
import System.Posix.Signals (sigKILL, signalProcess)
import System.Posix.Types (Fd)

data Checker = Checker
  { channel :: Fd,
    inputBuffer :: LineBuffer,
    unsent :: ByteString,
    task :: Maybe Task,
    served :: Int
  }

data Task = Task
  { from :: Id,
    question :: Question,
    -- | Time that is left for the answer.
    budget :: TimeBudget,
    overrun :: Maybe Overrun,
    compilerFailure :: Text
  }

-- | The limit for which a child was killed.
data Overrun = TooLate | TooLarge
  deriving (Eq, Show)

-- | By process id.
newtype CheckerPool = CheckerPool (Map.Map Int Checker)

emptyPool :: CheckerPool
emptyPool = CheckerPool Map.empty

-- | Result of a question.
data CheckResult
  = CheckAnswered Id Question ByteString
  | -- | The child ended before it answered: exit status, the limit that it exceeded, and the failure of the compiler.
    CheckerCrashed Id Question ProcessEnd (Maybe Overrun) Text

-- | Whether a question can be assigned at once, given the maximal number of children.
hasFreeSlot :: Int -> CheckerPool -> Bool
hasFreeSlot most (CheckerPool cs) = Map.size cs < most || any isIdle cs

isIdle :: Checker -> Bool
isIdle = isNothing . task

-- | Assigns a question to an idle child or to a new one.
--
-- The second argument makes the time budget of a child from the processor time that it has used.
assignQuestion :: IO (Int, Fd) -> (Double -> TimeBudget) -> Id -> Question -> CheckerPool -> IO CheckerPool
assignQuestion fork budgetFrom i q (CheckerPool cs) = case filter (isIdle . snd) (Map.toList cs) of
  (pid, c) : _ -> give pid c
  [] -> do
    (pid, fd) <- fork
    give pid (Checker fd emptyLineBuffer "" Nothing 0)
  where
    give pid c = do
      computed <- fromMaybe 0 <$> processorTime pid
      flushQuestion pid (CheckerPool (Map.insert pid c {unsent = asked, task = Just (Task i q (budgetFrom computed) Nothing "")} cs))
    asked = Lazy.toStrict (encode (object (("id" .= (0 :: Int)) : fields))) <> "\n"
    fields = case q of
      Check source -> ["op" .= ("check" :: Text), "source" .= source]
      Complete source (Position l c) -> ["op" .= ("complete" :: Text), "source" .= source, "line" .= l, "column" .= c]

-- | Kills the child that works on this request.
cancelQuestion :: Id -> CheckerPool -> IO ()
cancelQuestion i (CheckerPool cs) = forM_ [pid | (pid, Checker {task = Just t}) <- Map.toList cs, from t == i] end

end :: Int -> IO ()
end = signalProcess sigKILL . fromIntegral

-- | Descriptors to poll, by process id.
pollDescriptors :: CheckerPool -> [(Int, (Fd, Interest))]
pollDescriptors (CheckerPool cs) = [(pid, (channel c, if ByteString.null (unsent c) then Readable else ReadableOrWritable)) | (pid, c) <- Map.toList cs]

-- | Sends the unsent rest of a question.
flushQuestion :: Int -> CheckerPool -> IO CheckerPool
flushQuestion pid (CheckerPool cs) = case Map.lookup pid cs of
  Just c | not (ByteString.null (unsent c)) -> do
    sent <- send (channel c) (unsent c)
    pure . CheckerPool $ case sent of
      Sent n -> Map.insert pid c {unsent = ByteString.drop n (unsent c)} cs
      -- The child has died; its exit is handled when it is reaped.
      PeerClosed -> Map.insert pid c {unsent = ""} cs
  _ -> pure (CheckerPool cs)

-- | Reads the answers of a child. Ends a child that has answered its number of questions.
receiveAnswers :: Int -> CheckerPool -> IO ([CheckResult], CheckerPool)
receiveAnswers pid (CheckerPool cs) = case Map.lookup pid cs of
  Nothing -> pure ([], CheckerPool cs)
  Just c -> do
    got <- receive (channel c)
    case got of
      Bytes bytes descriptors -> do
        mapM_ closeLink descriptors
        let (found, rest) = splitLines (inputBuffer c) bytes
            (answers, c') = foldl understand ([], c {inputBuffer = rest}) found
            keep = CheckerPool (Map.insert pid c' cs)
        if not (null answers) && served c' >= questionsPerChecker
          then do
            closeFd (channel c')
            end pid
            pure (answers, CheckerPool (Map.delete pid cs))
          else do
            (more, after) <- if null answers then receiveAnswers pid keep else pure ([], keep)
            pure (answers ++ more, after)
      _ -> pure ([], CheckerPool cs)
  where
    understand (answers, c) l = case (l, task c) of
      (Line bytes, Just t) -> case Char8.uncons bytes of
        Just ('C', fields) -> (answers ++ [CheckAnswered (from t) (question t) fields], c {task = Nothing, served = served c + 1})
        Just ('!', words') -> (answers, c {task = Just t {compilerFailure = decodeUtf8With lenientDecode words'}})
        _ -> (answers, c)
      _ -> (answers, c)

-- | Number of questions that one child answers. Forking is then a few percent of the work, and GHC's caches stay small.
questionsPerChecker :: Int
questionsPerChecker = 50

-- | Kills children that have used up their time.
killOverdue :: Double -> CheckerPool -> IO CheckerPool
killOverdue now (CheckerPool cs) = do
  reviewed <- sequence [(,) (pid, t) <$> reviewChild now pid (budget t) | (pid, Checker {task = Just t}) <- Map.toList cs, isNothing (overrun t)]
  let kept = foldr (\((pid, t), left) -> maybe id (\b -> Map.adjust (\c -> c {task = Just t {budget = b}}) pid) left) cs reviewed
  killFor TooLate [pid | ((pid, _), Nothing) <- reviewed] (CheckerPool kept)

-- | The budget of a child now; nothing when it is used up.
reviewChild :: Double -> Int -> TimeBudget -> IO (Maybe TimeBudget)
reviewChild now pid budget'
  | now < nextReview budget' = pure (Just budget')
  | otherwise = (\computed -> review now (fromMaybe 0 computed) budget') <$> processorTime pid

-- | Kills these children, if they belong to the pool, because all children together need too much memory.
killTooLarge :: [Int] -> CheckerPool -> IO CheckerPool
killTooLarge pids (CheckerPool cs) = killFor TooLarge (filter (`Map.member` cs) pids) (CheckerPool cs)

killFor :: Overrun -> [Int] -> CheckerPool -> IO CheckerPool
killFor why pids (CheckerPool cs) = do
  forM_ pids end
  pure (CheckerPool (foldr (Map.adjust (\c -> c {task = fmap (\t -> t {overrun = Just why}) (task c)})) cs pids))

-- | Process ids, and whether the child is at work.
memberProcesses :: CheckerPool -> [(Int, Bool)]
memberProcesses (CheckerPool cs) = [(pid, not (isIdle c)) | (pid, c) <- Map.toList cs]

-- | When to call 'killOverdue' again.
pendingReviews :: CheckerPool -> [Double]
pendingReviews (CheckerPool cs) = [nextReview (budget t) | Checker {task = Just t} <- Map.elems cs, isNothing (overrun t)]

-- | Removes a child that has exited, if it belongs to the pool.
removeExited :: Int -> ProcessEnd -> CheckerPool -> IO ([CheckResult], CheckerPool)
removeExited pid how (CheckerPool cs) = case Map.lookup pid cs of
  Nothing -> pure ([], CheckerPool cs)
  Just _ -> do
    -- Output written before the exit may still be unread.
    (answers, CheckerPool rest) <- receiveAnswers pid (CheckerPool cs)
    case Map.lookup pid rest of
      Nothing -> pure (answers, CheckerPool rest)
      Just c -> do
        closeFd (channel c)
        pure (answers ++ maybe [] (\t -> [CheckerCrashed (from t) (question t) how (overrun t) (compilerFailure t)]) (task c), CheckerPool (Map.delete pid rest))
