-- |
-- Module      : Ros.Node.Publish
-- Description : Topics that this node publishes.
--
-- In: messages from the program, connections from subscribers. Out: every message to every subscriber,
-- in order; a slow subscriber loses the oldest ones once its queue is full, and delays
-- no other. A message goes out in the thread that publishes it when the system takes it at once, and otherwise in the
-- connection's own: a switch of threads less is a tenth of a round trip.
module Ros.Node.Publish
  ( Publisher,
    PublisherOptions (..),
    publisherOptions,
    openPublication,
    registerPublication,
    publish,
    publishPicked,
    subscriberCount,
    serveSubscriber,
    drained,
  )
where

import Control.Concurrent (threadWaitWrite)
import Control.Concurrent.Async (race_)
import Control.Concurrent.STM
import Control.Exception (evaluate, finally, mask, mask_, onException)
import Control.Monad (forM, forM_, unless, void, when)
import qualified Data.ByteString as B
import Data.Functor.Identity (Identity (..))
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, fromMaybe)
import Data.Proxy (Proxy (..))
import Network.Socket (Socket, withFdSocket)
import Network.Socket.ByteString (recv, sendAll, sendMany)
import Ros.Message (Message (..), RosBinary (..))
import Ros.Names (Naming (..))
import Ros.Net.Master (registerPublisher)
import Ros.Net.Rpc (sendAtOnce)
import Ros.Net.Tcpros
import Ros.Node.Core
import Ros.Queue
import System.Posix.Types (Fd (..))

-- | A topic open for messages of one type.
data Publisher a = Publisher Core Publication

data PublisherOptions = PublisherOptions
  { -- | messages that may wait for a slow subscriber; then the oldest goes
    queueSize :: Int,
    -- | a new subscriber gets the last message at once
    latched :: Bool,
    -- | runs the exchange with each subscriber, on its socket
    aroundSubscriber :: Socket -> IO () -> IO ()
  }

-- | 1,000 messages, not latched: a burst of a second at 1 kHz is kept.
publisherOptions :: PublisherOptions
publisherOptions = PublisherOptions 1000 False (const id)

-- | Registers the topic with the master, once per node and topic.
openPublication :: forall a. Message a => Core -> PublisherOptions -> String -> IO (Publisher a)
openPublication core options topic = do
  fresh <- Publication offer (latched options) <$> newTVarIO Nothing <*> newTVarIO 0 <*> newTVarIO Map.empty <*> newTVarIO (queueSize options) <*> pure (aroundSubscriber options)
  (isNew, p) <- atomically $ do
    known <- readTVar (publications core)
    case Map.lookup topic known of
      Nothing -> writeTVar (publications core) (Map.insert topic fresh known) >> pure (True, fresh)
      Just old
        | offerMd5 (pubOffer old) /= offerMd5 offer -> throwSTM (TwoTypes topic (offerType (pubOffer old)) (offerType offer))
        | otherwise -> modifyTVar' (pubBound old) (max (queueSize options)) >> pure (False, old)
  when isNew (registerPublication core p)
  pure (Publisher core p)
  where
    offer = Offer (ownName (coreNaming core)) topic (messageType kind) (messageMd5 kind) (messageDefinition kind)
    kind = Proxy :: Proxy a

-- | Tells the master. When it cannot be told now, "Ros.Node.Run" tells it later.
registerPublication :: Core -> Publication -> IO ()
registerPublication core p =
  registerPublisher (master core) (offerTopic (pubOffer p)) (offerType (pubOffer p))
    >>= either (const (atomically (writeTVar (unregistered core) True))) pure

-- | Sends a message to all who subscribe. Does not wait for them.
publish :: Message a => Publisher a -> a -> IO ()
publish publisher message = publishPicked publisher (pure . runIdentity) (Identity message)

-- | Sends one of several messages to all who subscribe. The action picks it for each of them right before it is sent, so a message that waits
-- can be replaced when it is too old.
publishPicked :: (Message a, Traversable f) => Publisher a -> (forall b. f b -> IO b) -> f a -> IO ()
publishPicked (Publisher _ p) pick messages = do
  n <- atomically (stateTVar (pubNext p) (\i -> (i, i + 1)))
  -- Here, so that an error in a message is thrown in the publisher's thread.
  encoded <- mapM (evaluate . frame . put . numbered n) messages
  let outgoing = pick encoded
  mask_ $ do
    free <- atomically $ do
      when (pubLatched p) (writeTVar (pubLast p) (Just outgoing))
      outlets <- readTVar (pubOutlets p)
      fmap catMaybes . forM (Map.elems outlets) $ \o -> do
        idle <- isIdle o
        if idle then Just o <$ writeTVar (outletBusy o) True else Nothing <$ push (outletQueue o) outgoing
    forM_ free $ \o -> do
      bytes <- outgoing `onException` atomically (writeTVar (outletBusy o) False)
      sent <- sendAtOnce (outletSocket o) bytes
      atomically $ do
        writeTVar (outletRest o) (B.drop sent bytes)
        counted o (if sent == B.length bytes then 1 else 0) sent
        writeTVar (outletBusy o) False

-- | Nothing is under way to the subscriber, nothing waits.
isIdle :: Outlet -> STM Bool
isIdle o = do
  busy <- readTVar (outletBusy o)
  rest <- readTVar (outletRest o)
  none <- isEmpty (outletQueue o)
  pure (not busy && B.null rest && none)

-- | So many whole messages and bytes more have been sent.
counted :: Outlet -> Int -> Int -> STM ()
counted o messages size = do
  (ms, bs) <- readTVar (outletSent o)
  let ms' = ms + messages
      bs' = bs + size
  ms' `seq` bs' `seq` writeTVar (outletSent o) (ms', bs')

-- | How many subscribers are connected now.
subscriberCount :: Publisher a -> STM Int
subscriberCount (Publisher _ p) = Map.size <$> readTVar (pubOutlets p)

-- | One subscriber with this header, until it leaves.
serveSubscriber :: Core -> Socket -> Fields -> IO ()
serveSubscriber core s theirs = do
  known <- readTVarIO (publications core)
  let agreed = do
        topic <- maybe (Left (MissingField "topic")) Right (lookup "topic" theirs)
        p <- maybe (Left (UnknownTopic topic)) Right (Map.lookup topic known)
        publisherAccepts (pubOffer p) theirs
        pure p
  case agreed of
    Left why -> sendAll s (frame (encodeFields (errorFields why)))
    Right p -> deliver core s p (fromMaybe "?" (lookup "callerid" theirs))

-- | Answers a subscriber that was accepted, and sends it what is published until it leaves. It has its place before
-- it is answered: once it knows that it is connected, nothing that is published passes it by.
deliver :: Core -> Socket -> Publication -> String -> IO ()
deliver core s p peer = do
  n <- freshId core
  bound <- readTVarIO (pubBound p)
  outlet <- Outlet peer s <$> newQueue bound <*> newTVarIO True <*> newTVarIO B.empty <*> newTVarIO (0, 0)
  let idle = writeTVar (outletBusy outlet) False
      answer = sendAll s (frame (encodeFields (publisherFields (pubLatched p) (pubOffer p)))) `finally` atomically idle
      -- What the system did not take at once, and what has been published since.
      writer = do
        mask $ \restore -> do
          batch <- atomically $ do
            readTVar (outletBusy outlet) >>= check . not
            rest <- swapTVar (outletRest outlet) B.empty
            batch <- if B.null rest then popAll (outletQueue outlet) else pure [pure rest]
            batch <$ writeTVar (outletBusy outlet) True
          sent <- restore (whenWritable s (sequence batch) >>= \bytes -> bytes <$ sendMany s bytes) `onException` atomically idle
          atomically (counted outlet (length sent) (sum (map B.length sent)) >> idle)
        writer
      -- A subscriber says nothing; when its side closes, this notices before the next message would.
      untilClosed = recv s 4096 >>= \b -> unless (B.null b) untilClosed
      -- The socket is closed afterwards: no thread may be sending any more.
      leave = do
        atomically (modifyTVar' (pubOutlets p) (Map.delete n))
        atomically (readTVar (outletBusy outlet) >>= check . not)
  -- The last message and the place among the outlets in one step: nothing falls between them.
  atomically $ do
    readTVar (pubLast p) >>= mapM_ (push (outletQueue outlet))
    modifyTVar' (pubOutlets p) (Map.insert n outlet)
  (answer >> pubAround p s (race_ (void writer) untilClosed)) `finally` leave

-- | An action at a moment at which the system takes something for this socket.
whenWritable :: Socket -> IO a -> IO a
whenWritable s act = withFdSocket s (threadWaitWrite . Fd) >> act

-- | All that was published has left this program.
drained :: Core -> STM Bool
drained core = do
  ps <- readTVar (publications core)
  outlets <- concatMap Map.elems <$> mapM (readTVar . pubOutlets) (Map.elems ps)
  and <$> mapM isIdle outlets
