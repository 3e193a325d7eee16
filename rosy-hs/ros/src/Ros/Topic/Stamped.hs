-- |
-- Module      : Ros.Topic.Stamped
-- Description : Topics that join by the stamps of their messages, not by their arrival.
--
-- A value is joined when the other topic has a value with the same stamp or an earlier one and a value with a later one: these two are its
-- bracket. So it comes out as late as the other topic's next value. What is older than all values of the other topic has no bracket and is left
-- out. Stamps are expected to grow; where a topic's clock is set back, what waits from before is left out.
module Ros.Topic.Stamped
  ( -- * Two topics as one
    everyNew,
    interpolate,

    -- * Bursts
    batch,
    batchUntil,

    -- * How topics join, as pure steps
    Brackets,
    noBracket,
    stepBrackets,
    EveryNew,
    noneYet,
    stepEveryNew,
  )
where

import Control.Concurrent (forkIO, threadDelay)
import Control.Concurrent.STM
import Control.Exception (throwIO)
import Control.Monad (void)
import Data.Bifunctor (first)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.Sequence (Seq (..), (|>))
import qualified Data.Sequence as Seq
import Ros.Header (HasHeader, stampOf)
import Ros.Message (ROSTime)
import Ros.Topic (Topic (..))
import qualified Ros.Topic as Topic
import Ros.Topic.Feed (allOf, feed, newFeed, nextOf)
import Ros.Topic.Util (concats, (<+>))

-- | Every value of either topic, with the value of the other whose stamp is nearest; of two that are equally near, the later one. A pair in which
-- each is the other's nearest comes once.
everyNew :: (HasHeader a, HasHeader b) => Topic IO a -> Topic IO b -> Topic IO (a, b)
everyNew l r = concats (Topic.mapAccum stepEveryNew noneYet (l <+> r))

-- | Every value of the second topic, with what the first one was then: the function gets the bracket and how far between its two stamps the
-- value is, from 0 to less than 1.
interpolate :: (HasHeader a, HasHeader b) => (a -> a -> Double -> a) -> Topic IO a -> Topic IO b -> Topic IO (a, b)
interpolate f l r = concats (fmap (map between) (Topic.mapAccum (stepBrackets stampOf stampOf) noBracket (l <+> r)))
  where
    between (x1, x2, y) = (f x1 x2 (share (stampOf x1) (stampOf x2) (stampOf y)), y)
    share start end t = fromIntegral (nanoseconds t - nanoseconds start) / fromIntegral (nanoseconds end - nanoseconds start)

-- | Lists of values that arrive together: the first one opens a window of so many seconds, and what arrives in it is one list. The
-- next value opens the next window. This goes by arrival, since a stamp never tells that no more will come.
batch :: Double -> Topic IO a -> Topic IO [a]
batch seconds = batchUntil $ do
  over <- newTVarIO False
  void (forkIO (threadDelay (max 0 (round (seconds * 1000000))) >> atomically (writeTVar over True)))
  pure (readTVar over >>= check)

-- | The same with a window that closes when the transaction of this action can run.
batchUntil :: IO (STM ()) -> Topic IO a -> Topic IO [a]
batchUntil open source = Topic $ do
  found <- newFeed 1
  void (forkIO (feed found source))
  let next = atomically (nextOf found) >>= either throwIO pure >>= \x -> open >>= gather [x]
      gather xs closed = do
        more <- atomically (fmap Left (closed >> allOf found) `orElse` fmap Right (nextOf found))
        case more of
          Left rest -> (reverse xs ++) <$> either throwIO pure rest
          Right x -> either throwIO (\y -> gather (y : xs) closed) x
  runTopic (Topic.repeatM next)

-- | Values of the first topic from the start of the bracket that is next, and values of the second that wait for the end of theirs. Both in the order of
-- their stamps.
data Brackets a b = Brackets (Seq a) (Seq b)

noBracket :: Brackets a b
noBracket = Brackets Seq.empty Seq.empty

-- | How many values of a topic may wait for the other: ten seconds of a topic with 100 a second. Of more, the oldest are left out.
patience :: Int
patience = 1000

-- | The values of the second topic whose brackets are complete now. It depends on the order of the stamps, not on which topic is faster.
stepBrackets :: (a -> ROSTime) -> (b -> ROSTime) -> Brackets a b -> Either a b -> ([(a, a, b)], Brackets a b)
stepBrackets left right (Brackets marks waiting) new = case new of
  Left x -> complete (append left marks x) waiting
  Right y -> complete marks (append right waiting y)
  where
    complete (x1 :<| later@(x2 :<| _)) ys@(y :<| rest)
      | right y < left x1 = complete (x1 :<| later) rest
      | right y < left x2 = first ((x1, x2, y) :) (complete (x1 :<| later) rest)
      | otherwise = complete later ys
    complete xs ys = ([], Brackets xs ys)

-- | One older than the last means that the clock was set back.
append :: (a -> ROSTime) -> Seq a -> a -> Seq a
append at xs x = case xs of
  _ :|> before | at x < at before -> Seq.singleton x
  _ -> Seq.drop (Seq.length xs + 1 - patience) (xs |> x)

-- | A value with its number in its topic, which tells values with equal stamps apart.
type Numbered a = (Int, a)

-- | Brackets in both directions, the numbers of the next values, and whom the values that can still be chosen have chosen themselves.
data EveryNew a b = EveryNew (Brackets (Numbered a) (Numbered b)) (Brackets (Numbered b) (Numbered a)) (Int, Int) (IntMap Int) (IntMap Int)

noneYet :: EveryNew a b
noneYet = EveryNew noBracket noBracket (0, 0) IntMap.empty IntMap.empty

stepEveryNew :: (HasHeader a, HasHeader b) => EveryNew a b -> Either a b -> ([(a, b)], EveryNew a b)
stepEveryNew (EveryNew forRight forLeft (n, m) ofLeft ofRight) new = ([(x, y) | ((_, x), (_, y)) <- byRight ++ byLeft], EveryNew forRight' forLeft' counted ofLeft' ofRight')
  where
    counted = either (const (n + 1, m)) (const (n, m + 1)) new
    numbered = either (\x -> Left (n, x)) (\y -> Right (m, y)) new
    (bracketsR, forRight') = stepBrackets stamped stamped forRight numbered
    (bracketsL, forLeft') = stepBrackets stamped stamped forLeft (either Right Left numbered)
    chosenByRight = [(nearest x1 x2 y, y) | (x1, x2, y) <- bracketsR]
    chosenByLeft = [(x, nearest y1 y2 x) | (y1, y2, x) <- bracketsL]
    byRight = [pair | pair@((i, _), (j, _)) <- chosenByRight, IntMap.lookup i ofLeft /= Just j]
    byLeft = [pair | pair@((i, _), (j, _)) <- chosenByLeft, IntMap.lookup j chosenNow /= Just i]
    chosenNow = foldr (\((i, _), (j, _)) -> IntMap.insert j i) ofRight chosenByRight
    ofRight' = choosable forLeft' chosenNow
    ofLeft' = choosable forRight' (foldr (\((i, _), (j, _)) -> IntMap.insert i j) ofLeft chosenByLeft)
    choosable (Brackets marks _) = case marks of
      (oldest, _) :<| _ -> snd . IntMap.partitionWithKey (\k _ -> k < oldest)
      _ -> id

stamped :: HasHeader a => Numbered a -> ROSTime
stamped = stampOf . snd

nearest :: (HasHeader a, HasHeader b) => Numbered a -> Numbered a -> Numbered b -> Numbered a
nearest x1 x2 y = if at y - at x1 < at x2 - at y then x1 else x2
  where
    at :: HasHeader c => Numbered c -> Integer
    at = nanoseconds . stamped

nanoseconds :: ROSTime -> Integer
nanoseconds (s, n) = fromIntegral s * 1000000000 + fromIntegral n
