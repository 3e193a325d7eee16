-- |
-- Module      : Ros.Node.Run
-- Description : The life of a node, from its arguments to its last message.
--
-- In: a name, arguments and environment. Out: a running 'Core' for as long as an action needs it.
-- However the action ends, what was published is sent, every topic is unregistered, and no thread or
-- socket stays.
module Ros.Node.Run
  ( Settings (..),
    settingsFromSystem,
    masterAddress,
    namingOf,
    withCore,
  )
where

import Control.Concurrent.Async (cancel, forConcurrently_, waitCatch, withAsync)
import Control.Concurrent.MVar (newMVar, withMVar)
import Control.Concurrent.STM
import Control.Exception
import Control.Monad (forM, forM_, forever, unless, void)
import Data.Either (fromRight)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, fromMaybe, listToMaybe)
import Network.Socket
import Ros.Names
import Ros.Net.HostLookup (addressesOf)
import Ros.Net.Master
import Ros.Net.Rpc
import Ros.Net.Slave
import Ros.Net.Tcpros (offerTopic, offerType)
import Ros.Net.XmlRpc
import Ros.Node.Core
import Ros.Node.Publish
import Ros.Node.Service
import Ros.Node.Subscribe
import Ros.SlicedTimeout (timeoutInSlices)
import System.Environment (getArgs, getEnvironment, getProgName)
import System.Posix.Process (getProcessID)

-- | What a node takes from outside the program.
data Settings = Settings
  { arguments :: Arguments,
    environment :: [(String, String)],
    programName :: String
  }

settingsFromSystem :: IO Settings
settingsFromSystem = Settings . readArguments <$> getArgs <*> getEnvironment <*> getProgName

-- | Runs the action inside a node of this name.
withCore :: Settings -> String -> (Core -> IO a) -> IO a
withCore settings name act = do
  uri <- either throwIO pure (masterAddress settings)
  host <- hostFor settings uri
  let onlyHere = host `elem` ["127.0.0.1", "localhost"]
  withSocket onlyHere $ \calls callPort -> withSocket onlyHere $ \topics topicPort -> do
    core <-
      Core (namingOf settings name) uri (Uri host callPort) host topicPort (programName settings)
        <$> newTVarIO Map.empty
        <*> newTVarIO Map.empty
        <*> newTVarIO Map.empty
        <*> newTVarIO minBound
        <*> newTVarIO Map.empty
        <*> newTVarIO False
        <*> newEmptyTMVarIO
        <*> newTVarIO Map.empty
        <*> newTVarIO 0
    loggerServices core
    effects <- newTQueueIO
    started <- newMVar ()
    isOver <- newTVarIO False
    let start = withMVar started $ \() -> do
          _ <- spawnLinked core (serveCalls calls (answering core effects))
          _ <- spawnLinked core (accepting topics (serveConnection core))
          _ <- spawnLinked core (forever (atomically (readTQueue effects) >>= carryOut core))
          forM_ (privateParams (arguments settings)) $ \(k, v) -> setParam (master core) (resolve (coreNaming core) ('~' : k)) (literal v)
          spawnLinked core (watchMaster isOver core)
        -- Who watches must not register again what is being taken back, also not by a call that is on its way: it would take the
        -- name from a node that comes next.
        end watching = do
          atomically (writeTVar isOver True)
          _ <- timeoutInSlices lastCall (waitCatch watching)
          cancel watching
    bracket start end (const (act core)) `finally` finish core
  where
    withSocket onlyHere use = bracket (listenAnywhere onlyHere) (close . fst) (uncurry use)

-- | Where the master is: @__master@, @ROS_MASTER_URI@, or this computer.
masterAddress :: Settings -> Either NodeError Uri
masterAddress settings = maybe (Left (StrangeMaster address)) Right (readUri address)
  where
    address = fromMaybe "http://localhost:11311" (firstOf [special "__master" (arguments settings), fromEnvironment "ROS_MASTER_URI" settings])

-- | The names of a node that its program calls so.
namingOf :: Settings -> String -> Naming
namingOf settings = nodeFullName (arguments settings) (fromEnvironment "ROS_NAMESPACE" settings)

-- | A variable that is empty counts as one that is not set.
fromEnvironment :: String -> Settings -> Maybe String
fromEnvironment key = nonEmpty . lookup key . environment
  where
    nonEmpty v = if v == Just "" then Nothing else v

firstOf :: [Maybe a] -> Maybe a
firstOf ms = listToMaybe (catMaybes ms)

-- | The address that others are told: @__hostname@, @__ip@, @ROS_HOSTNAME@, @ROS_IP@, and without any of
-- them the address by which this machine reaches the master.
hostFor :: Settings -> Uri -> IO String
hostFor settings uri = maybe (fromRight "127.0.0.1" <$> (try towards :: IO (Either IOException String))) pure told
  where
    told = firstOf ([special k (arguments settings) | k <- ["__hostname", "__ip"]] ++ [nonEmpty =<< lookup k (environment settings) | k <- ["ROS_HOSTNAME", "ROS_IP"]])
    nonEmpty v = if null v then Nothing else Just v
    towards = do
      addresses <- addressesOf defaultHints {addrSocketType = Datagram, addrFamily = AF_INET} (uriHost uri) (uriPort uri)
      case addresses of
        [] -> pure "127.0.0.1"
        a : _ -> bracket (socket AF_INET Datagram defaultProtocol) close $ \s -> do
          connect s (addrAddress a) -- sends nothing: it only chooses the way
          own <- getSocketName s
          fromMaybe "127.0.0.1" . fst <$> getNameInfo [NI_NUMERICHOST] True False own

-- | Answers a call; what it makes the node do comes after, in order, so that no caller waits for it.
answering :: Core -> TQueue Effect -> Call -> IO Answer
answering core effects c = do
  s <- slaveOf core
  let (reply, todo) = answerCall s c
  atomically (mapM_ (writeTQueue effects) todo)
  pure reply

carryOut :: Core -> Effect -> IO ()
carryOut core effect = case effect of
  PublishersAre topic uris -> publishersAre core topic uris
  EndBecause why -> requestEnd core (AskedTo why)
  ParamIs key v -> atomically $ do
    watchers <- readTVar (paramWatchers core)
    mapM_ ($ v) (fromMaybe [] (Map.lookup (resolve (coreNaming core) key) watchers))

slaveOf :: Core -> IO Slave
slaveOf core = do
  pid <- getProcessID
  atomically $ do
    ps <- readTVar (publications core)
    ss <- readTVar (subscriptions core)
    outs <- forM (Map.toList ps) $ \(t, p) -> readTVar (pubOutlets p) >>= mapM (outlet t) . Map.toList
    ins <- forM (Map.toList ss) $ \(t, s) -> readTVar (subPublishers s) >>= fmap concat . mapM (inlet t) . Map.toList
    pure
      Slave
        { slavePid = fromIntegral pid,
          slaveMaster = coreMaster core,
          slaveHost = coreHost core,
          slavePort = coreTcpPort core,
          published = [(t, offerType (pubOffer p)) | (t, p) <- Map.toList ps],
          subscribed = [(t, offerType (subOffer s)) | (t, s) <- Map.toList ss],
          connections = concat outs ++ concat ins
        }
  where
    outlet t (n, o) = uncurry (Connection n (outletPeer o) Outbound t) <$> readTVar (outletSent o)
    inlet t (u, i) = do
      live <- readTVar (inletConnected i)
      counts <- readTVar (inletReceived i)
      pure [uncurry (Connection (inletId i) (showUri u) Inbound t) counts | live]

-- | How often a node looks whether its master still knows it, microseconds. One small call; rospy and roscpp
-- do not look, and stay unknown to a master that was restarted.
watchEvery :: Int
watchEvery = 1000000

-- | Time for the registrations on their way when a node ends, microseconds. A master answers one in a few milliseconds.
lastCall :: Int
lastCall = 1000000

-- | Registers what the master does not know: at the start, if it was not there yet, and after it was
-- restarted. Ends the node when another has taken its name. Who had the name before this node was known is no such other: a node
-- that was killed stays registered. Until the node is over.
watchMaster :: TVar Bool -> Core -> IO ()
watchMaster isOver core = go True False
  where
    go wasThere wasKnown = do
      found <- lookupNode (master core) (ownName (coreNaming core))
      missed <- atomically (swapTVar (unregistered core) False)
      case found of
        Left (Refused _) -> registerAll core >> rest True False
        Right (Just u)
          | u == coreUri core -> do
            complete <- isComplete core
            unless (complete && not missed) (registerAll core)
            rest True True
          | wasKnown && not missed -> requestEnd core (AskedTo ("a new node is called " ++ ownName (coreNaming core)))
        Right _ -> registerAll core >> rest True False
        Left why -> do
          if wasThere then complain core (explainRpcError why ++ "; waiting for the ROS master") else pure ()
          atomically (writeTVar (unregistered core) True)
          rest False wasKnown
    rest there known = do
      isDue <- registerDelay watchEvery
      over <- atomically $ do
        over <- readTVar isOver
        over <$ (readTVar isDue >>= check . (over ||))
      unless over (go there known)

-- | Whether the master knows what 'registerAll' tells it last. A master that was restarted between two looks knows the node from
-- the first thing that the node told it since, and nothing of what the node told its predecessor.
isComplete :: Core -> IO Bool
isComplete core = (== Right (Just (serviceAddress core))) <$> lookupService (master core) (resolve (coreNaming core) loggersService)

registerAll :: Core -> IO ()
registerAll core = do
  readTVarIO (publications core) >>= mapM_ (registerPublication core)
  readTVarIO (subscriptions core) >>= mapM_ (registerSubscription core)
  -- A service is the last to be known, so one who can call it finds the rest.
  readTVarIO (paramWatchers core) >>= mapM_ (subscribeParam (master core)) . Map.keys
  readTVarIO (services core) >>= mapM_ (registerOffered core) . Map.keys

-- | Sends what is waiting, says goodbye, and ends all threads. A peer that does not read is given up after 'drainTimeout', a master that
-- does not answer after 'farewellTimeout'.
finish :: Core -> IO ()
finish core = do
  requestEnd core Finished
  void (timeoutInSlices drainTimeout (atomically (drained core >>= check)))
  ps <- readTVarIO (publications core)
  ss <- readTVarIO (subscriptions core)
  ws <- readTVarIO (paramWatchers core)
  offered <- readTVarIO (services core)
  let goodbyes =
        [void (unregisterPublisher (master core) (offerTopic (pubOffer p))) | p <- Map.elems ps]
          ++ [void (unregisterSubscriber (master core) (offerTopic (subOffer s))) | s <- Map.elems ss]
          ++ map (unregisterOffered core) (Map.keys offered)
          ++ [void (unsubscribeParam (master core) k) | k <- Map.keys ws]
  unless (null goodbyes) (withAsync (forConcurrently_ goodbyes id) (void . timeoutInSlices farewellTimeout . waitCatch))
  stopAll core

-- | Half a second, in microseconds: a base's own watchdog takes 0.6 s.
drainTimeout :: Int
drainTimeout = 500000

-- | Five seconds, in microseconds: as long as a call may take ("Ros.Net.Rpc"). A master that has ended refuses at once, so only one on
-- a computer that is gone is waited for so long.
farewellTimeout :: Int
farewellTimeout = 5000000

-- | A private parameter as rospy reads it from a command line: a number or truth value if it looks like one.
literal :: String -> Value
literal v = case reads v of
  [(i, "")] -> VInt i
  _ -> case reads v of
    [(d, "")] -> VDouble d
    _ -> case v of
      "true" -> VBool True
      "True" -> VBool True
      "false" -> VBool False
      "False" -> VBool False
      _ -> VString v
