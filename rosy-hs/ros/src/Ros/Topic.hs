-- |
-- Module      : Ros.Topic
-- Description : A topic as a stream of actions.
--
-- A topic is an action that gives one value and the rest of the topic. Nothing happens until
-- values are pulled. In the laws below a topic stands for the list of values it gives:
--
-- > fmap f t   = map f t
-- > f <*> t    = zipWith ($) f t      -- lock step: left is pulled first
-- > filter p t = Prelude.filter p t
--
-- These functions need no threads and no clock; "Ros.Topic.Util" has those that do.
module Ros.Topic
  ( -- * What it is
    Topic (..),

    -- * Making one
    repeat,
    repeatM,
    unfold,
    iterate,
    cons,

    -- * Taking one apart
    uncons,
    head,
    tail,
    take,
    take_,
    splitAt,
    break,
    tails,

    -- * Changing the values
    mapM,
    mapM_,
    forever,
    force,
    scan,
    mapAccum,
    join,

    -- * Giving some values for some others
    IterCont (..),
    IterContM (..),
    yield,
    skip,
    yieldM,
    skipM,
    metamorph,
    metamorphM,
    bimetamorph,
    bimetamorphM,
    bimetamorphE,
    bimetamorphME,

    -- * Choosing among them
    filter,
    catMaybes,
    drop,
    dropWhile,
    takeWhile,
    takeWhile_,

    -- * Showing
    showTopic,
    hoist,
  )
where

import qualified Control.Monad as M
import Control.Monad.IO.Class (MonadIO (..))
import Data.Bifunctor (bimap, second)
import Prelude hiding (break, drop, dropWhile, filter, head, iterate, mapM, mapM_, repeat, splitAt, tail, take, takeWhile)

-- | An action that gives a value and what comes after it. A topic has no end.
newtype Topic m a = Topic {runTopic :: m (a, Topic m a)}

instance Functor m => Functor (Topic m) where
  fmap f (Topic t) = Topic (fmap (bimap f (fmap f)) t)

-- | Lock step: one value from each, the left one first.
instance Applicative m => Applicative (Topic m) where
  pure x = let t = Topic (pure (x, t)) in t
  Topic f <*> Topic t = Topic ((\(g, fs) (x, xs) -> (g x, fs <*> xs)) <$> f <*> t)

-- | As fast as it is pulled.
repeat :: Applicative m => a -> Topic m a
repeat = pure

-- | Runs the action at every pull.
repeatM :: Monad m => m a -> Topic m a
repeatM act = t where t = Topic (act >>= \x -> pure (x, t))

unfold :: Functor m => (s -> m (a, s)) -> s -> Topic m a
unfold step s = Topic (fmap (second (unfold step)) (step s))

iterate :: Applicative m => (a -> a) -> a -> Topic m a
iterate f = unfold (\x -> pure (x, f x))

cons :: Applicative m => a -> Topic m a -> Topic m a
cons x t = Topic (pure (x, t))

uncons :: Topic m a -> m (a, Topic m a)
uncons = runTopic

head :: Functor m => Topic m a -> m a
head = fmap fst . runTopic

-- | Waits for one value and forgets it.
tail :: Monad m => Topic m a -> Topic m a
tail t = Topic (runTopic t >>= runTopic . snd)

take :: Monad m => Int -> Topic m a -> m [a]
take n = fmap fst . splitAt n

take_ :: Monad m => Int -> Topic m a -> m ()
take_ n = M.void . take n

splitAt :: Monad m => Int -> Topic m a -> m ([a], Topic m a)
splitAt = go []
  where
    go seen n t
      | n <= 0 = pure (reverse seen, t)
      | otherwise = runTopic t >>= \(x, rest) -> go (x : seen) (n - 1) rest

-- | The values up to the first that satisfies the predicate, and the topic that starts with that one.
break :: Monad m => (a -> Bool) -> Topic m a -> m ([a], Topic m a)
break p = go []
  where
    go seen t = do
      (x, rest) <- runTopic t
      if p x then pure (reverse seen, Topic (pure (x, rest))) else go (x : seen) rest

takeWhile :: Monad m => (a -> Bool) -> Topic m a -> m [a]
takeWhile p = fmap fst . break (not . p)

takeWhile_ :: Monad m => (a -> Bool) -> Topic m a -> m ()
takeWhile_ p = M.void . takeWhile p

drop :: Monad m => Int -> Topic m a -> Topic m a
drop n t = Topic (splitAt n t >>= runTopic . snd)

dropWhile :: Monad m => (a -> Bool) -> Topic m a -> Topic m a
dropWhile p t = Topic (break (not . p) t >>= runTopic . snd)

-- | At every value, the topic that starts there.
tails :: Monad m => Topic m a -> Topic m (Topic m a)
tails t = Topic $ do
  (x, rest) <- runTopic t
  pure (cons x rest, tails rest)

mapM :: Monad m => (a -> m b) -> Topic m a -> Topic m b
mapM f t = Topic $ do
  (x, rest) <- runTopic t
  y <- f x
  pure (y, mapM f rest)

-- | Runs the action on every value. Does not return.
mapM_ :: Monad m => (a -> m b) -> Topic m a -> m ()
mapM_ f t = runTopic t >>= \(x, rest) -> f x >> mapM_ f rest

-- | Pulls for ever, for the effects.
forever :: Monad m => Topic m a -> m b
forever t = runTopic t >>= forever . snd

-- | Waits for the first value, and gives the topic that begins with it.
force :: Monad m => Topic m a -> m (Topic m a)
force t = runTopic t >>= \now -> pure (Topic (pure now))

-- | > scan f z t = tail (scanl f z t)
scan :: Monad m => (b -> a -> b) -> b -> Topic m a -> Topic m b
scan f z t = Topic $ do
  (x, rest) <- runTopic t
  let y = f z x
  y `seq` pure (y, scan f y rest)

-- | A state that every value changes.
--
-- > mapAccum f s t = snd (mapAccumL (\s x -> swap (f s x)) s t)
mapAccum :: Monad m => (s -> a -> (b, s)) -> s -> Topic m a -> Topic m b
mapAccum f s t = Topic $ do
  (x, rest) <- runTopic t
  let (y, s') = f s x
  pure (y, mapAccum f s' rest)

-- | What comes of a value, if anything, and what is done with the next one.
newtype IterCont a b = IterCont (Maybe b, a -> IterCont a b)

instance Functor (IterCont a) where
  fmap f (IterCont (y, next)) = IterCont (fmap f y, fmap f . next)

-- | The same with effects.
newtype IterContM m a b = IterContM (Maybe b, a -> m (IterContM m a b))

instance Functor m => Functor (IterContM m a) where
  fmap f (IterContM (y, next)) = IterContM (fmap f y, fmap (fmap f) . next)

-- | Gives a value, and goes on with the function.
yield :: b -> (a -> IterCont a b) -> IterCont a b
yield y next = IterCont (Just y, next)

-- | Gives nothing, and goes on with the function.
skip :: (a -> IterCont a b) -> IterCont a b
skip next = IterCont (Nothing, next)

yieldM :: Monad m => b -> (a -> m (IterContM m a b)) -> m (IterContM m a b)
yieldM y next = pure (IterContM (Just y, next))

skipM :: Monad m => (a -> m (IterContM m a b)) -> m (IterContM m a b)
skipM next = pure (IterContM (Nothing, next))

-- | Gives a value or none for each value, and chooses what is done with the next.
--
-- > filter p t = metamorph go t where go x = if p x then yield x go else skip go
metamorph :: Monad m => (a -> IterCont a b) -> Topic m a -> Topic m b
metamorph f t = Topic $ do
  (x, rest) <- runTopic t
  let IterCont (y, next) = f x
  given y (metamorph next rest)

metamorphM :: Monad m => (a -> m (IterContM m a b)) -> Topic m a -> Topic m b
metamorphM f t = Topic $ do
  (x, rest) <- runTopic t
  IterContM (y, next) <- f x
  given y (metamorphM next rest)

-- | Two of them along one topic: what the first gives for a value, then what the second gives.
bimetamorph :: Monad m => (a -> IterCont a b) -> (a -> IterCont a b) -> Topic m a -> Topic m b
bimetamorph f g t = Topic $ do
  (x, rest) <- runTopic t
  let (IterCont (y, f'), IterCont (z, g')) = (f x, g x)
  given y (Topic (given z (bimetamorph f' g' rest)))

bimetamorphM :: Monad m => (a -> m (IterContM m a b)) -> (a -> m (IterContM m a b)) -> Topic m a -> Topic m b
bimetamorphM f g t = Topic $ do
  (x, rest) <- runTopic t
  IterContM (y, f') <- f x
  IterContM (z, g') <- g x
  given y (Topic (given z (bimetamorphM f' g' rest)))

-- | The same, with what each of them gives told apart.
bimetamorphE :: Monad m => (a -> IterCont a b) -> (a -> IterCont a c) -> Topic m a -> Topic m (Either b c)
bimetamorphE f g = bimetamorph (fmap Left . f) (fmap Right . g)

bimetamorphME :: Monad m => (a -> m (IterContM m a b)) -> (a -> m (IterContM m a c)) -> Topic m a -> Topic m (Either b c)
bimetamorphME f g = bimetamorphM (fmap (fmap Left) . f) (fmap (fmap Right) . g)

-- | This value, if it is one, before the topic.
given :: Monad m => Maybe b -> Topic m b -> m (b, Topic m b)
given y rest = maybe (runTopic rest) (\v -> pure (v, rest)) y

-- | Runs the actions that the topic gives.
join :: Monad m => Topic m (m a) -> Topic m a
join = mapM id

filter :: Monad m => (a -> Bool) -> Topic m a -> Topic m a
filter p t = Topic (runTopic t >>= \(x, rest) -> if p x then pure (x, filter p rest) else runTopic (filter p rest))

catMaybes :: Monad m => Topic m (Maybe a) -> Topic m a
catMaybes t = Topic $ do
  (x, rest) <- runTopic t
  maybe (runTopic (catMaybes rest)) (\y -> pure (y, catMaybes rest)) x

-- | Prints every value as it passes.
showTopic :: (MonadIO m, Show a) => Topic m a -> Topic m ()
showTopic = mapM (liftIO . print)

-- | The same topic in another monad.
hoist :: Functor n => (forall x. m x -> n x) -> Topic m a -> Topic n a
hoist f t = Topic (fmap (fmap (hoist f)) (f (runTopic t)))
