-- |
-- Module      : Ros.Topic.Transformers
-- Description : Topics whose actions have a state or an environment, as topics without.
--
-- > counted = repeatM (modify (+ 1) >> get) :: Topic (StateT Int IO) Int
-- > runTopicState' counted 0                :: Topic IO Int
module Ros.Topic.Transformers
  ( runTopicState,
    runTopicState',
    runTopicReader,
    liftMap,
  )
where

import Control.Monad.Trans.Class (MonadTrans (..))
import Control.Monad.Trans.Reader (ReaderT (..))
import qualified Control.Monad.Trans.State.Lazy as Lazy
import qualified Control.Monad.Trans.State.Strict as Strict
import Ros.Topic (Topic (..))
import qualified Ros.Topic as Topic

-- | Each value's action begins with the state that the one before it has left; the first with this one.
runTopicState :: Functor m => Topic (Lazy.StateT s m) a -> s -> Topic m a
runTopicState = stateful Lazy.runStateT

-- | The same for the strict kind of state.
runTopicState' :: Functor m => Topic (Strict.StateT s m) a -> s -> Topic m a
runTopicState' = stateful Strict.runStateT

stateful :: Functor m => (t (a, Topic t a) -> s -> m ((a, Topic t a), s)) -> Topic t a -> s -> Topic m a
stateful run t s = Topic ((\((x, rest), s') -> (x, stateful run rest s')) <$> run (runTopic t) s)

-- | Every action reads the same environment.
runTopicReader :: Functor m => Topic (ReaderT r m) a -> r -> Topic m a
runTopicReader t r = Topic.hoist (`runReaderT` r) t

-- | Changes every value by an action of the transformed monad.
--
-- > runTopicReader (liftMap (pure . f) t) r = fmap f t
liftMap :: (MonadTrans t, Monad m, Monad (t m)) => (a -> t m b) -> Topic m a -> Topic (t m) b
liftMap f = Topic.mapM f . Topic.hoist lift
