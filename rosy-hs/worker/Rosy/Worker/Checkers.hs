{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Checkers
-- Description : The children that answer questions about programs, one question after the other.
--
-- Forking a child for each question would take as long as answering it. So a few are kept, each for a number of questions; none
-- of them ever runs a program. One that dies, or says what it was not asked, is replaced, and its question is answered by how it ended.
module Rosy.Worker.Checkers
  ( Checkers,
    noCheckers,
    Heard (..),

    -- * Asking
    hasRoom,
    askOne,
    stopAsking,

    -- * What happens
    ears,
    listenTo,
    sendMore,
    overdue,
    buried,
    nextDeadline,
  )
where

import Control.Monad (forM_)
import Data.Aeson (encode, object, (.=))
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing)
import Data.Text (Text)
import Data.Text.Encoding (decodeUtf8With)
import Data.Text.Encoding.Error (lenientDecode)
import Rosy.Worker.Problem (Place (..))
import Rosy.Worker.Sys
import Rosy.Worker.Wire
import System.Posix.IO (closeFd)
import System.Posix.Signals (sigKILL, signalProcess)
import System.Posix.Types (Fd)

data Checker = Checker
  { ear :: Fd,
    heard :: Lines,
    unsent :: ByteString,
    task :: Maybe Task,
    served :: Int
  }

data Task = Task
  { from :: Id,
    question :: Question,
    -- | When the answer must be there; 'GHC.Clock.getMonotonicTime'.
    deadline :: Double,
    late :: Bool,
    lastWords :: Text
  }

-- | By process id.
newtype Checkers = Checkers (Map.Map Int Checker)

noCheckers :: Checkers
noCheckers = Checkers Map.empty

-- | What became of a question.
data Heard
  = Answered Id Question ByteString
  | -- | The child ended instead: how, whether because it took too long, and what the compiler said.
    Broken Id Question Ended Bool Text

-- | Whether a question would be taken up at once, with so many children.
hasRoom :: Int -> Checkers -> Bool
hasRoom most (Checkers cs) = Map.size cs < most || any isIdle cs

isIdle :: Checker -> Bool
isIdle = isNothing . task

-- | Gives a question to a child that has none, or to a new one.
askOne :: IO (Int, Fd) -> Double -> Id -> Question -> Checkers -> IO Checkers
askOne fork until' i q (Checkers cs) = case filter (isIdle . snd) (Map.toList cs) of
  (pid, c) : _ -> give pid c
  [] -> do
    (pid, fd) <- fork
    give pid (Checker fd noLines "" Nothing 0)
  where
    give pid c = sendMore pid (Checkers (Map.insert pid c {unsent = asked, task = Just (Task i q until' False "")} cs))
    asked = Lazy.toStrict (encode (object (("id" .= (0 :: Int)) : fields))) <> "\n"
    fields = case q of
      Check source -> ["op" .= ("check" :: Text), "source" .= source]
      Complete source (Place l c) -> ["op" .= ("complete" :: Text), "source" .= source, "line" .= l, "column" .= c]

-- | Ends the child that works on this.
stopAsking :: Id -> Checkers -> IO ()
stopAsking i (Checkers cs) = forM_ [pid | (pid, Checker {task = Just t}) <- Map.toList cs, from t == i] end

end :: Int -> IO ()
end = signalProcess sigKILL . fromIntegral

-- | What to wait for, with the process id that it belongs to.
ears :: Checkers -> [(Int, (Fd, Wanted))]
ears (Checkers cs) = [(pid, (ear c, if ByteString.null (unsent c) then ToRead else ToWriteOrRead)) | (pid, c) <- Map.toList cs]

-- | Sends what has not gone out yet.
sendMore :: Int -> Checkers -> IO Checkers
sendMore pid (Checkers cs) = case Map.lookup pid cs of
  Just c | not (ByteString.null (unsent c)) -> do
    sent <- send (ear c) (unsent c)
    pure . Checkers $ case sent of
      Sent n -> Map.insert pid c {unsent = ByteString.drop n (unsent c)} cs
      -- It has died, which will be noticed.
      Gone -> Map.insert pid c {unsent = ""} cs
  _ -> pure (Checkers cs)

-- | Takes what a child has to say. One that has answered often enough has done its work.
listenTo :: Int -> Checkers -> IO ([Heard], Checkers)
listenTo pid (Checkers cs) = case Map.lookup pid cs of
  Nothing -> pure ([], Checkers cs)
  Just c -> do
    got <- receive (ear c)
    case got of
      Bytes bytes passenger -> do
        mapM_ closeFd passenger
        let (found, rest) = cut (heard c) bytes
            (answers, c') = foldl understand ([], c {heard = rest}) found
            keep = Checkers (Map.insert pid c' cs)
        if not (null answers) && served c' >= mostServed
          then do
            closeFd (ear c')
            end pid
            pure (answers, Checkers (Map.delete pid cs))
          else do
            (more, after) <- if null answers then listenTo pid keep else pure ([], keep)
            pure (answers ++ more, after)
      _ -> pure ([], Checkers cs)
  where
    understand (answers, c) l = case (l, task c) of
      (Line bytes, Just t) -> case Char8.uncons bytes of
        Just ('C', fields) -> (answers ++ [Answered (from t) (question t) fields], c {task = Nothing, served = served c + 1})
        Just ('!', words') -> (answers, c {task = Just t {lastWords = decodeUtf8With lenientDecode words'}})
        _ -> (answers, c)
      _ -> (answers, c)

-- | Questions that one child answers: then forking is a few hundredths of the work, and what GHC remembers stays small.
mostServed :: Int
mostServed = 50

-- | Ends those that take too long.
overdue :: Double -> Checkers -> IO Checkers
overdue now (Checkers cs) = do
  let over c = maybe False (\t -> deadline t <= now && not (late t)) (task c)
  forM_ [pid | (pid, c) <- Map.toList cs, over c] end
  pure (Checkers (Map.map (\c -> if over c then c {task = fmap (\t -> t {late = True}) (task c)} else c) cs))

nextDeadline :: Checkers -> [Double]
nextDeadline (Checkers cs) = [deadline t | Checker {task = Just t} <- Map.elems cs, not (late t)]

-- | A child has ended, perhaps one of these.
buried :: Int -> Ended -> Checkers -> IO ([Heard], Checkers)
buried pid how (Checkers cs) = case Map.lookup pid cs of
  Nothing -> pure ([], Checkers cs)
  Just _ -> do
    -- What it said before it ended may still be on its way.
    (answers, Checkers rest) <- listenTo pid (Checkers cs)
    case Map.lookup pid rest of
      Nothing -> pure (answers, Checkers rest)
      Just c -> do
        closeFd (ear c)
        pure (answers ++ maybe [] (\t -> [Broken (from t) (question t) how (late t) (lastWords t)]) (task c), Checkers (Map.delete pid rest))
