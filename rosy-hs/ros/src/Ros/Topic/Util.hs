-- |
-- Module      : Ros.Topic.Util
-- Description : Topics that run side by side, are shared, keep a rate, or look at neighbours.
--
-- Joining two topics that speak when they please needs a thread for each. Those threads start at the
-- first pull, wait while what they have found is not taken, end when it cannot be taken any more, and hand
-- an exception of their source to the puller.
module Ros.Topic.Util
  ( -- * Two topics as one
    (<+>),
    interleave,
    merge,
    mergeList,
    bothNew,
    everyNew,
    firstThenSecond,
    leftThenRight,

    -- * One topic as several
    tee,
    teeEager,
    fan,
    share,
    partition,

    -- * Time
    topicRate,
    interruptible,
    forkTopic,
    newestOn,

    -- * A topic as a list
    toList,
    fromList,

    -- * Neighbours
    consecutive,
    slidingWindow,
    slidingWindowG,
    finiteDifference,
    weightedMean,
    weightedMean2,
    weightedMeanNormalized,
    simpsonsRule,

    -- * Some values, or parts of them
    subsample,
    filterBy,
    gate,
    concats,
    topicOn,

    -- * How two topics join, as pure steps
    BothNew,
    neitherNew,
    stepBothNew,
    EveryNew,
    noneYet,
    stepEveryNew,
  )
where

import Control.Concurrent (forkIO)
import Control.Concurrent.MVar (MVar, modifyMVar, newMVar)
import Control.Concurrent.STM
import Control.Exception (SomeException, throwIO, try)
import Control.Monad (void)
import Control.Monad.IO.Class (MonadIO (..))
import Data.Bifunctor (bimap)
import qualified Data.Foldable as Foldable
import Data.IORef (atomicModifyIORef', newIORef, readIORef)
import Data.Maybe (fromMaybe)
import Ros.Rate (rateLimiter)
import Ros.Topic (Topic (..))
import qualified Ros.Topic as Topic
import Ros.Topic.Feed (feed, newFeed, taking)
import System.IO.Unsafe (unsafeInterleaveIO)

infixl 7 <+>

-- | Both topics, each value when it arrives. Nothing is dropped.
(<+>) :: Topic IO a -> Topic IO b -> Topic IO (Either a b)
l <+> r = interleave [fmap Left l, fmap Right r]

merge :: Topic IO a -> Topic IO a -> Topic IO a
merge l r = interleave [l, r]

mergeList :: [Topic IO a] -> Topic IO a
mergeList = interleave

-- | All topics, each value when it arrives. Nothing is dropped; a source that is faster than the reader
-- waits.
interleave :: [Topic IO a] -> Topic IO a
interleave sources = Topic $ do
  found <- newFeed (length sources)
  mapM_ (forkIO . feed found) sources
  runTopic (taking found)

-- | Pairs in which both values are new. The later one of the two decides when; of the side that came first,
-- the newest value counts, and older ones are forgotten.
bothNew :: Topic IO a -> Topic IO b -> Topic IO (a, b)
bothNew l r = Topic.catMaybes (Topic.mapAccum stepBothNew neitherNew (l <+> r))

-- | What 'bothNew' remembers: the newest value of the side that came first.
data BothNew a b = Neither | OneNew (Either a b)

neitherNew :: BothNew a b
neitherNew = Neither

stepBothNew :: BothNew a b -> Either a b -> (Maybe (a, b), BothNew a b)
stepBothNew (OneNew (Left x)) (Right y) = (Just (x, y), Neither)
stepBothNew (OneNew (Right y)) (Left x) = (Just (x, y), Neither)
stepBothNew _ new = (Nothing, OneNew new)

-- | After both have spoken once: a pair for every value of either, with the other's newest.
everyNew :: Topic IO a -> Topic IO b -> Topic IO (a, b)
everyNew l r = Topic.catMaybes (Topic.mapAccum stepEveryNew noneYet (l <+> r))

-- | What 'everyNew' remembers: the newest value of each side.
data EveryNew a b = EveryNew (Maybe a) (Maybe b)

noneYet :: EveryNew a b
noneYet = EveryNew Nothing Nothing

stepEveryNew :: EveryNew a b -> Either a b -> (Maybe (a, b), EveryNew a b)
stepEveryNew (EveryNew x y) new = ((,) <$> x' <*> y', EveryNew x' y')
  where
    x' = either Just (const x) new
    y' = either (const y) Just new

-- | A value of the left, then one of the right: pairs of the newest left and the first right after it.
firstThenSecond :: Topic IO a -> Topic IO b -> Topic IO (a, b)
firstThenSecond l r = leftThenRight (l <+> r)

-- | The same pairs of values that are in one topic already.
leftThenRight :: Monad m => Topic m (Either a b) -> Topic m (a, b)
leftThenRight = Topic.catMaybes . Topic.mapAccum step Nothing
  where
    step _ (Left x) = (Nothing, Just x)
    step (Just x) (Right y) = (Just (x, y), Nothing)
    step Nothing (Right _) = (Nothing, Nothing)

-- | Two readers of one topic. Its effects happen once, when the faster reader pulls; the slower one finds the
-- values waiting. What both have read is forgotten.
tee :: Topic IO a -> IO (Topic IO a, Topic IO a)
tee t = (\shared -> (shared, shared)) <$> remembered t

-- | As 'tee', and the values are pulled as soon as there are any, also without a reader: the oldest wait when there are many.
teeEager :: Topic IO a -> IO (Topic IO a, Topic IO a)
teeEager t = forkTopic t >>= tee

-- | Pulls in a thread of its own, from now on, so that the source keeps its own rhythm.
forkTopic :: Topic IO a -> IO (Topic IO a)
forkTopic t = do
  found <- newFeed 1
  void (forkIO (feed found t))
  pure (taking found)

-- | As many readers as asked for.
fan :: Int -> Topic IO a -> IO [Topic IO a]
fan n t = replicate n <$> remembered t

-- | Any number of readers, now or later: each sees what is pulled after its own first pull.
share :: Topic IO a -> IO (Topic IO a)
share t = do
  start <- remembered t
  newest <- newIORef (0 :: Int, start)
  let follow n cell = Topic $ do
        (x, rest) <- runTopic cell
        atomicModifyIORef' newest (\now -> (if fst now > n then now else (n + 1, rest), ()))
        pure (x, follow (n + 1) rest)
  pure (Topic (readIORef newest >>= runTopic . uncurry follow))

-- | A topic whose every step runs once and is remembered for as long as a reader stands before it.
remembered :: Topic IO a -> IO (Topic IO a)
remembered t = walk <$> newMVar (NotYet t)
  where
    walk :: MVar (Cell a) -> Topic IO a
    walk cell = Topic $ do
      (x, next) <- modifyMVar cell $ \now -> case now of
        Known x next -> pure (now, (x, next))
        NotYet source -> do
          (x, rest) <- runTopic source
          next <- newMVar (NotYet rest)
          pure (Known x next, (x, next))
      pure (x, walk next)

data Cell a = NotYet (Topic IO a) | Known a (MVar (Cell a))

-- | Those that satisfy the predicate, and the others.
partition :: (a -> Bool) -> Topic IO a -> IO (Topic IO a, Topic IO a)
partition p t = bimap (Topic.filter p) (Topic.filter (not . p)) <$> tee t

-- | At most @hz@ values a second: the first at once, each later one no earlier than its turn.
topicRate :: MonadIO m => Double -> Topic m a -> Topic m a
topicRate hz t = Topic $ do
  pause <- liftIO (rateLimiter hz (pure ()))
  let go u = Topic (liftIO pause >> runTopic u >>= \(x, rest) -> pure (x, go rest))
  runTopic (go t)

-- | The values of lists that arrive; a new list takes the place of what is left of the one before.
interruptible :: Foldable t => Topic IO (t a) -> Topic IO a
interruptible lists = Topic $ do
  latest <- newEmptyTMVarIO
  void (forkIO (gather latest (fmap Foldable.toList lists)))
  let next xs = Topic $ do
        newer <- atomically (case xs of [] -> Just <$> takeTMVar latest; _ -> tryTakeTMVar latest)
        case fromMaybe (Right xs) newer of
          Left e -> throwIO (e :: SomeException)
          Right [] -> runTopic (next [])
          Right (x : rest) -> pure (x, next rest)
  runTopic (next [])
  where
    gather latest t = do
      pulled <- try (runTopic t)
      atomically (tryTakeTMVar latest >> putTMVar latest (fst <$> pulled))
      either (const (pure ())) (gather latest . snd) pulled

-- | All values as an endless list. It is pulled when it is looked at, in the thread that looks.
toList :: Topic IO a -> IO [a]
toList t = unsafeInterleaveIO (runTopic t >>= \(x, rest) -> (x :) <$> toList rest)

-- | The list, then its last value for ever: a topic has no end. The list must not be empty.
fromList :: Applicative m => [a] -> Topic m a
fromList xs = case xs of
  [] -> errorWithoutStackTrace "Ros.Topic.Util.fromList: the list is empty, and a topic has no end"
  [x] -> pure x
  x : rest -> Topic (pure (x, fromList rest))

-- | The newest value of the topic at every value of the other.
newestOn :: Topic IO a -> Topic IO b -> Topic IO (a, b)
newestOn t ticks = Topic.catMaybes (Topic.mapAccum step Nothing (t <+> ticks))
  where
    step _ (Left x) = (Nothing, Just x)
    step x (Right y) = (fmap (,y) x, x)

-- | > concats t = concat t
concats :: (Monad m, Foldable t) => Topic m (t a) -> Topic m a
concats t = Topic $ do
  (xs, rest) <- runTopic t
  runTopic (foldr Topic.cons (concats rest) xs)

-- | Each value with the one after it.
consecutive :: Monad m => Topic m a -> Topic m (a, a)
consecutive t = Topic (runTopic t >>= \(x, rest) -> runTopic (go x rest))
  where
    go x rest = Topic (runTopic rest >>= \(y, more) -> pure ((x, y), go y more))

-- | The newest @n@ values as one, the oldest first; starts when there are so many.
--
-- > slidingWindow 2 (fmap pure t) = the lists of two neighbours
slidingWindow :: (Monad m, Monoid a) => Int -> Topic m a -> Topic m a
slidingWindow n = fmap mconcat . windows n

-- | The sum of the newest @n@ values.
slidingWindowG :: (Monad m, Num a) => Int -> Topic m a -> Topic m a
slidingWindowG n = fmap sum . windows n

windows :: Monad m => Int -> Topic m a -> Topic m [a]
windows n t = Topic (Topic.splitAt (n - 1) t >>= \(xs, rest) -> runTopic (go xs rest))
  where
    go xs rest = Topic (runTopic rest >>= \(x, more) -> let w = xs ++ [x] in pure (w, go (drop 1 w) more))

-- | Leaves out @n@ values before each that it gives.
subsample :: Monad m => Int -> Topic m a -> Topic m a
subsample n t = Topic (runTopic (Topic.drop n t) >>= \(x, rest) -> pure (x, subsample n rest))

-- | > finiteDifference f t = zipWith f t (tail t)
finiteDifference :: Monad m => (a -> a -> b) -> Topic m a -> Topic m b
finiteDifference f = fmap (uncurry f) . consecutive

-- | @weightedMean w plus scale@: a running mean, in which what came before weighs @w@ and each new value @1 - w@. It
-- begins with the mean of the first two. For values that are not numbers, hence the two functions.
weightedMean :: (Monad m, Num n) => n -> (a -> a -> a) -> (n -> a -> a) -> Topic m a -> Topic m a
weightedMean w = weightedMean2 w (1 - w)

-- | As 'weightedMean', with both weights.
weightedMean2 :: Monad m => n -> n -> (a -> a -> a) -> (n -> a -> a) -> Topic m a -> Topic m a
weightedMean2 old new plus scale = weightedMeanNormalized old new plus scale id

-- | And with a function for the sum, so that whole numbers can be weighed: @weightedMeanNormalized 7 1 (+) (*) (`div` 8)@.
weightedMeanNormalized :: Monad m => n -> n -> (b -> b -> c) -> (n -> a -> b) -> (c -> a) -> Topic m a -> Topic m a
weightedMeanNormalized old new plus scale normalize t = Topic (runTopic t >>= \(x, more) -> runTopic (Topic.scan step x more))
  where
    step mean x = normalize (plus (scale old mean) (scale new x))

-- | Integrates over every three neighbours, which are one unit of time apart: a third of the outer ones and four of the middle one.
-- The functions add and scale values that need not be numbers.
simpsonsRule :: (Monad m, Fractional n) => (a -> a -> a) -> (n -> a -> a) -> Topic m a -> Topic m a
simpsonsRule plus scale t = fmap area (consecutive (consecutive t))
  where
    area ((a, b), (_, c)) = scale (1 / 3) (plus (plus a (scale 4 b)) c)

-- | The first value that satisfies the first predicate, the first one after it that satisfies the second, and so on.
filterBy :: Monad m => Topic m (a -> Bool) -> Topic m a -> Topic m a
filterBy predicates t = Topic $ do
  (p, more) <- runTopic predicates
  (x, rest) <- runTopic (Topic.dropWhile (not . p) t)
  pure (x, filterBy more rest)

-- | A value of the left for every value of the right.
gate :: Applicative m => Topic m a -> Topic m b -> Topic m a
gate t ticks = const <$> t <*> ticks

-- | Changes a part of each value: how to take it out, how to put the new one back, and what makes the function that changes it.
topicOn :: Monad m => (a -> b) -> (a -> c -> d) -> m (b -> m c) -> Topic m a -> Topic m d
topicOn part back changing t = Topic $ do
  change <- changing
  runTopic (Topic.mapM (\x -> back x <$> change (part x)) t)
