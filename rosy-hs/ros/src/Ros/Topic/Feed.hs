-- |
-- Module      : Ros.Topic.Feed
-- Description : Bounded queue between a topic that is pulled by a thread of its own and its reader.
--
-- For "Ros.Topic.Util" and "Ros.Topic.Stamped". The thread ends when nothing can take what it finds; an exception of its source goes
-- into the queue and so to the reader.
module Ros.Topic.Feed
  ( Feed,
    newFeed,
    feed,
    nextOf,
    allOf,
    taking,
  )
where

import Control.Concurrent.STM
import Control.Exception (BlockedIndefinitelyOnMVar (..), BlockedIndefinitelyOnSTM (..), Handler (..), SomeException, catches, fromException, throwIO, try)
import Ros.Topic (Topic (..))
import qualified Ros.Topic as Topic

type Feed a = TBQueue (Either SomeException a)

-- | How many values of one source may wait to be taken: enough that a burst does not switch threads for
-- each of its values, few enough that a source without a rhythm of its own fills no memory.
ahead :: Int
ahead = 16

-- | For so many sources.
newFeed :: Int -> IO (Feed a)
newFeed sources = newTBQueueIO (fromIntegral (ahead * max 1 sources))

-- | Pulls for ever. Ends quietly when the reader is gone, since then the queue can never empty, and when the source
-- can never speak again: in both cases the runtime says so. Any other exception of the source goes to the reader.
feed :: Feed a -> Topic IO a -> IO ()
feed found = quietly . go
  where
    go t = do
      pulled <- try (runTopic t)
      case pulled of
        Left e
          | Just BlockedIndefinitelyOnSTM <- fromException e -> pure ()
          | Just BlockedIndefinitelyOnMVar <- fromException e -> pure ()
          | otherwise -> atomically (writeTBQueue found (Left e))
        Right (x, rest) -> atomically (writeTBQueue found (Right x)) >> go rest
    quietly act = act `catches` [Handler (\BlockedIndefinitelyOnSTM -> pure ()), Handler (\BlockedIndefinitelyOnMVar -> pure ())]

nextOf :: Feed a -> STM (Either SomeException a)
nextOf = readTBQueue

-- | What has come and was not taken; the first exception among it instead.
allOf :: Feed a -> STM (Either SomeException [a])
allOf = fmap sequence . flushTBQueue

-- | What was fed into the queue; an exception of the source is thrown here.
taking :: Feed a -> Topic IO a
taking found = Topic.mapM (either throwIO pure) (Topic.repeatM (atomically (nextOf found)))
