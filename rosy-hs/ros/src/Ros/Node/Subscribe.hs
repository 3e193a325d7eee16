-- |
-- Module      : Ros.Node.Subscribe
-- Description : Topics that this node listens to.
--
-- In: lists of publishers, from the master. Out: their messages, in the queues of those who subscribed.
-- One thread per publisher asks it for the topic, connects and reads; when the connection is lost it
-- tries again for as long as the master lists that publisher.
module Ros.Node.Subscribe
  ( openSubscription,
    registerSubscription,
    publishersAre,
    publisherCount,
  )
where

import Control.Concurrent (threadDelay, yield)
import Control.Concurrent.Async (cancel)
import Control.Concurrent.MVar (newMVar, withMVar)
import Control.Concurrent.STM
import Control.Exception (IOException, bracket, finally, mask_, try)
import Control.Monad (forM, forM_, when)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import qualified Data.Set as Set
import Network.Socket (Socket, close)
import Network.Socket.ByteString (sendAll)
import Ros.Message (Message (..), decode)
import Ros.Names (Naming (..))
import Ros.Net.Master (registerSubscriber)
import Ros.Net.Rpc
import Ros.Net.Tcpros
import Ros.Net.XmlRpc
import Ros.Node.Core
import Ros.Queue
import Ros.Topic (Topic (..))
import qualified Ros.Topic as Topic
import Ros.Topic.Util (share)

-- | The messages that arrive from now on, for any number of readers. So many may wait until the first of them pulls; then the oldest goes.
-- What one reader has pulled waits for the others.
openSubscription :: forall a. Message a => Core -> Int -> String -> IO (Topic IO a)
openSubscription core bound topic = do
  queue <- newQueue bound
  fresh <- Subscription offer <$> newTVarIO Map.empty <*> newTVarIO [push queue] <*> newMVar ()
  isNew <- atomically $ do
    known <- readTVar (subscriptions core)
    case Map.lookup topic known of
      Nothing -> True <$ writeTVar (subscriptions core) (Map.insert topic fresh known)
      Just old
        | offerMd5 (subOffer old) /= offerMd5 offer -> throwSTM (TwoTypes topic (offerType (subOffer old)) (offerType offer))
        | otherwise -> False <$ modifyTVar' (subSinks old) (push queue :)
  when isNew (registerSubscription core fresh)
  share (Topic.catMaybes (Topic.mapM understand (Topic.repeatM (atomically (pop queue)))))
  where
    offer = Offer (ownName (coreNaming core)) topic (messageType kind) (messageMd5 kind) (messageDefinition kind)
    kind = Proxy :: Proxy a
    understand :: ByteString -> IO (Maybe a)
    understand bytes = case decode bytes of
      Right x -> pure (Just x)
      Left why -> Nothing <$ complain core ("a message on " ++ topic ++ " was left out: " ++ show why)

-- | Tells the master, and connects to the publishers it knows. Those that are connected already stay: a
-- master that has just restarted does not know them yet.
registerSubscription :: Core -> Subscription -> IO ()
registerSubscription core s = withMVar (subTurn s) $ \() ->
  registerSubscriber (master core) (offerTopic (subOffer s)) (offerType (subOffer s)) >>= \case
    Left _ -> atomically (writeTVar (unregistered core) True)
    Right listed -> do
      live <- atomically $ do
        inlets <- readTVar (subPublishers s)
        Map.keys . Map.filter id <$> traverse (readTVar . inletConnected) inlets
      choosePublishers core s (listed ++ live)

-- | Exactly these publish the topic now.
publishersAre :: Core -> String -> [Uri] -> IO ()
publishersAre core topic now = do
  known <- readTVarIO (subscriptions core)
  forM_ (Map.lookup topic known) $ \s -> withMVar (subTurn s) $ \() -> choosePublishers core s now

-- | Begins to listen to those who are new and leaves those who are gone, without waiting for either.
choosePublishers :: Core -> Subscription -> [Uri] -> IO ()
choosePublishers core s now = mask_ $ do
  old <- readTVarIO (subPublishers s)
  let gone = Map.withoutKeys old (Set.fromList now)
  opened <- forM (Set.toList (Set.fromList now `Set.difference` Map.keysSet old)) $ \u -> do
    n <- freshId core
    connected <- newTVarIO False
    received <- newTVarIO (0, 0)
    a <- spawn core (listenTo core s u connected received)
    pure (u, Inlet n a connected received)
  atomically (writeTVar (subPublishers s) (Map.union (Map.fromList opened) (old Map.\\ gone)))
  forM_ gone $ \i -> spawn core (cancel (inletThread i))

-- | How many publishers are connected now.
publisherCount :: Core -> String -> STM Int
publisherCount core topic = do
  known <- readTVar (subscriptions core)
  case Map.lookup topic known of
    Nothing -> pure 0
    Just s -> readTVar (subPublishers s) >>= fmap (length . filter id) . mapM (readTVar . inletConnected) . Map.elems

-- | Connects, reads, and begins again when that ends. A publisher that cannot be reached is asked less and
-- less often, one that refuses is told of once.
listenTo :: Core -> Subscription -> Uri -> TVar Bool -> TVar (Int, Int) -> IO ()
listenTo core s uri connected received = go firstPause Nothing
  where
    go pause said = do
      outcome <- attempt `finally` atomically (writeTVar connected False)
      case outcome of
        Left why | Just why /= said, Refusal t <- why -> complain core (offerTopic (subOffer s) ++ " from " ++ showUri uri ++ ": " ++ t)
        _ -> pure ()
      threadDelay pause
      case outcome of
        Right () -> go firstPause Nothing
        Left why -> go (min lastPause (pause * 2)) (Just why)
    attempt = do
      asked <- call uri (Call "requestTopic" [VString me, VString (offerTopic (subOffer s)), VArray [VArray [VString "TCPROS"]]])
      case asked of
        Right (VArray [VInt 1, _, VArray (VString "TCPROS" : VString host : VInt port : _)]) -> do
          r <- try (bracket (connectTo host port) close (readMessages s connected received))
          pure (either (\e -> Left (Lost (show (e :: IOException)))) id r)
        Right (VArray [_, VString why, _]) -> pure (Left (Lost why))
        Right other -> pure (Left (Refusal ("a strange answer: " ++ show other)))
        Left e -> pure (Left (Lost (explainRpcError e)))
    me = offerCaller (subOffer s)

-- | Why there is no connection: worth telling the person at the terminal, or the way of networks.
data NoConnection = Refusal String | Lost String
  deriving (Eq)

-- | Pauses between attempts, microseconds. A base that restarts is back within a second.
firstPause, lastPause :: Int
firstPause = 50000
lastPause = 1600000

readMessages :: Subscription -> TVar Bool -> TVar (Int, Int) -> Socket -> IO (Either NoConnection ())
readMessages s connected received socket = do
  sendAll socket (frame (encodeFields (subscriberFields (subOffer s))))
  next <- receiver socket
  header next noBytes
  where
    header next seen = do
      more <- next
      if B.null more
        then pure (Left (Lost "it closed the connection"))
        else case feed maxFrame seen more of
          Left (TooLong n) -> pure (Left (Refusal ("a header of " ++ show n ++ " bytes")))
          Right ([], rest) -> header next rest
          Right (h : messages, rest) -> case decodeFields h of
            Left why -> pure (Left (Refusal why))
            Right theirs -> case subscriberAccepts (subOffer s) theirs of
              Left why -> pure (Left (Refusal (explainDisagreement why)))
              Right () -> do
                atomically (writeTVar connected True)
                deliver messages
                body next rest
    body next seen = do
      more <- next
      if B.null more
        then pure (Right ())
        else case feed maxFrame seen more of
          Left (TooLong n) -> pure (Left (Refusal ("a message of " ++ show n ++ " bytes")))
          -- Those who wait for the messages go first, before the system is asked for more.
          Right (messages, rest) -> deliver messages >> yield >> body next rest
    deliver [] = pure ()
    deliver messages = atomically $ do
      sinks <- readTVar (subSinks s)
      forM_ messages $ \m -> forM_ sinks ($ m)
      (ms, bs) <- readTVar received
      writeTVar received $! (let ms' = ms + length messages; bs' = bs + sum (map B.length messages) in ms' `seq` bs' `seq` (ms', bs'))
