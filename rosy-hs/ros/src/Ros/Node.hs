-- |
-- Module      : Ros.Node
-- Description : Programs that are ROS nodes.
--
-- A node subscribes to topics, makes new topics of them, and publishes those:
--
-- > main = runNode "echo" $ do
-- >   heard <- subscribe "chatter"
-- >   advertise "echo" (fmap louder heard)
-- >   runHandler_ print heard
--
-- The words are roshask's. Names are resolved and remapped as ROS does (@ros-program chatter:=talk@),
-- @ROS_MASTER_URI@, @ROS_IP@, @ROS_HOSTNAME@ and @ROS_NAMESPACE@ are obeyed. The master may come
-- later than the node, and may be restarted.
module Ros.Node
  ( -- * Running one
    Node,
    runNode,
    withNode,
    withNodeIn,
    Settings (..),
    settingsFromSystem,
    Ending (..),
    NodeError (..),
    explainNodeError,

    -- * Topics
    TopicName,
    Topic (..),
    topicRate,
    ROSTime,
    ROSDuration,

    -- * Topics in
    subscribe,
    subscribeBuffered,
    runHandler,
    runHandler_,

    -- * Topics out
    advertise,
    advertiseBuffered,
    advertiseLatched,
    Publisher,
    PublisherOptions (..),
    publisherOptions,
    publisher,
    publisherWith,
    publish,
    publishPicked,

    -- * Who is connected
    awaitSubscribers,
    awaitListeners,
    awaitPublishers,
    isConnectedTo,

    -- * Services
    ServiceName,
    Service (..),
    ServiceError (..),
    explainServiceError,
    offerService,
    requestService,
    withServiceConnection,
    awaitService,

    -- * Parameters
    Param (..),
    Value (..),
    ParamName,
    getParam,
    getParamOpt,
    setParam,
    hasParam,
    deleteParam,
    searchParam,
    watchParam,

    -- * The node itself
    getName,
    getNamespace,
    getArguments,
    getShutdownAction,
    awaitEnd,
    nodeIO,
    getClock,
    liftIO,

    -- * For what builds on nodes
    askCore,
  )
where

import Control.Concurrent (ThreadId)
import Control.Concurrent.Async (asyncThreadId, forConcurrently_, withAsync)
import Control.Concurrent.STM
import Control.Exception (bracket, throwIO)
import Control.Monad (join, void, when)
import Control.Monad.IO.Class (MonadIO (..))
import Control.Monad.Trans.Reader (ReaderT (..), ask, asks)
import Data.Either (fromRight)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import Data.Time.Clock.POSIX (getPOSIXTime)
import Ros.Message (Message, ROSDuration, ROSTime, fromSeconds)
import Ros.Names (Name, Naming (..), plain, resolve)
import qualified Ros.Net.Master as Master
import Ros.Net.Rpc (RpcError, explainRpcError)
import Ros.Net.XmlRpc (Value (..))
import Ros.Node.Core
import Ros.Node.Param (Param (..))
import Ros.Node.Publish
import Ros.Node.Run
import Ros.Node.Service
import Ros.Node.Subscribe
import qualified Ros.Rosgraph_msgs.Clock as Clock
import Ros.Service.Class
import Ros.SlicedTimeout (timeoutInSlices)
import Ros.Topic (Topic (..))
import qualified Ros.Topic as Topic
import Ros.Topic.Util (topicRate)
import System.IO (BufferMode (..), hSetBuffering, stderr, stdout)
import System.Posix.Signals (Handler (..), installHandler, sigINT, sigTERM)
import System.Timeout (timeout)

-- | What a program does as a node.
newtype Node a = Node (ReaderT Env IO a)
  deriving (Functor, Applicative, Monad, MonadIO, MonadFail)

data Env = Env {envCore :: Core, envSettings :: Settings}

type TopicName = Name

type ParamName = Name

type ServiceName = Name

-- | Runs a node until it is told to end: by Ctrl-C, by the system, by the master, by 'getShutdownAction'. When
-- a handler or a topic fails, the node ends and the exception is thrown here.
runNode :: String -> Node a -> IO ()
runNode name node = do
  -- What is printed is wanted now, also when it goes to a file, and a line at a time, whatever else is printed.
  mapM_ (`hSetBuffering` LineBuffering) [stdout, stderr]
  settings <- settingsFromSystem
  why <- withNodeIn settings name (interruptible' (node >> awaitEnd))
  case why of
    AskedTo reason -> putStrLn (name ++ " ends: " ++ reason)
    Failed e -> throwIO e
    _ -> pure ()
  where
    interruptible' n = do
      core <- askCore
      nodeIO (\run -> onSignals (requestEnd core Interrupted) (run n))

-- | Runs a node for as long as its actions take, and does not touch signals.
withNode :: String -> Node a -> IO a
withNode name node = settingsFromSystem >>= \s -> withNodeIn s name node

withNodeIn :: Settings -> String -> Node a -> IO a
withNodeIn settings name (Node r) = withCore settings name (\core -> runReaderT r (Env core settings))

onSignals :: IO () -> IO a -> IO a
onSignals act body = bracket (mapM install [sigINT, sigTERM]) (mapM_ restore) (const body)
  where
    install s = (,) s <$> installHandler s (Catch act) Nothing
    restore (s, old) = installHandler s old Nothing

-- | Waits until the node is told to end, and says why.
awaitEnd :: Node Ending
awaitEnd = askCore >>= \core -> liftIO (atomically (readTMVar (ending core)))

askCore :: Node Core
askCore = Node (asks envCore)

-- | A node inside IO: @nodeIO (\\run -> forkIO (run n))@.
nodeIO :: ((forall b. Node b -> IO b) -> IO a) -> Node a
nodeIO use = Node (ask >>= \env -> liftIO (use (\(Node r) -> runReaderT r env)))

resolved :: Name -> Node Name
resolved n = (\core -> resolve (coreNaming core) n) <$> askCore

-- | The messages that arrive from now on. Each reader of the topic gets all of them. Up to 1,000 may wait until one pulls; then the oldest goes.
subscribe :: Message a => TopicName -> Node (Topic IO a)
subscribe = subscribeBuffered 1000

-- | As 'subscribe', with room for so many. With 1, what is pulled is always the newest.
subscribeBuffered :: Message a => Int -> TopicName -> Node (Topic IO a)
subscribeBuffered n topic = do
  core <- askCore
  resolved topic >>= liftIO . openSubscription core n

-- | Runs an action on every value, beside the rest of the node.
runHandler :: (a -> IO b) -> Topic IO a -> Node ThreadId
runHandler act t = askCore >>= \core -> liftIO (asyncThreadId <$> spawnLinked core (Topic.mapM_ act t))

runHandler_ :: (a -> IO b) -> Topic IO a -> Node ()
runHandler_ act t = void (runHandler act t)

-- | Publishes every value of the topic, as soon as it has it: see 'Ros.Topic.Util.topicRate'.
advertise :: Message a => TopicName -> Topic IO a -> Node ()
advertise = advertiseWith publisherOptions

-- | With room for so many messages that a slow subscriber has not taken.
advertiseBuffered :: Message a => Int -> TopicName -> Topic IO a -> Node ()
advertiseBuffered n = advertiseWith publisherOptions {queueSize = n}

-- | Late subscribers get the last message at once.
advertiseLatched :: Message a => TopicName -> Topic IO a -> Node ()
advertiseLatched = advertiseWith publisherOptions {latched = True}

advertiseWith :: Message a => PublisherOptions -> TopicName -> Topic IO a -> Node ()
advertiseWith options topic t = publisherWith options topic >>= \p -> runHandler_ (publish p) t

-- | A topic to publish to by hand.
publisher :: Message a => TopicName -> Node (Publisher a)
publisher = publisherWith publisherOptions

publisherWith :: Message a => PublisherOptions -> TopicName -> Node (Publisher a)
publisherWith options topic = do
  core <- askCore
  resolved topic >>= liftIO . openPublication core options

-- | Waits until so many subscribe.
awaitSubscribers :: Publisher a -> Int -> Node ()
awaitSubscribers p n = liftIO (atomically (subscriberCount p >>= check . (>= n)))

-- | Waits until all whom the master knows to listen to this node's topics are connected, so that what is published next passes none
-- of them by; for so many microseconds at most. Those that do not answer are not waited for: the master keeps nodes that were killed.
awaitListeners :: Int -> Node ()
awaitListeners limit = do
  core <- askCore
  known <- Map.fromList . fromRight [] <$> liftIO (Master.allSubscribers (master core))
  ours <- liftIO (readTVarIO (publications core))
  gone <- liftIO (newTVarIO Set.empty)
  let listeners = Map.intersectionWith (,) known ours
      complete (nodes, p) = do
        peers <- map outletPeer . Map.elems <$> readTVar (pubOutlets p)
        dead <- readTVar gone
        check (all (\n -> n `elem` peers || Set.member n dead) nodes)
      probe n = do
        answers <- timeout answerTimeout (Master.nodeAnswers (master core) n)
        when (answers /= Just True) (atomically (modifyTVar' gone (Set.insert n)))
  liftIO . withAsync (forConcurrently_ (Set.fromList (concatMap fst (Map.elems listeners))) probe) $ \_ ->
    void (timeoutInSlices limit (atomically (mapM_ complete listeners)))

-- | Time for a node to answer whether it is there, microseconds: peers answer in a millisecond.
answerTimeout :: Int
answerTimeout = 1000000

-- | Waits until so many publishers of the topic are connected.
awaitPublishers :: TopicName -> Int -> Node ()
awaitPublishers topic n = do
  core <- askCore
  t <- resolved topic
  liftIO (atomically (publisherCount core t >>= check . (>= n)))

-- | Whether this topic has a publisher now; for transactions that wait for a change.
isConnectedTo :: TopicName -> Node (STM Bool)
isConnectedTo topic = do
  core <- askCore
  t <- resolved topic
  pure ((> 0) <$> publisherCount core t)

-- | Answers the calls of a service, each in a thread of its connection. A text is the reason why there is no response; a handler
-- that throws has failed for its caller alone.
offerService :: Service s => s -> ServiceName -> (Request s -> IO (Either String (Response s))) -> Node ()
offerService s name act = do
  core <- askCore
  n <- resolved name
  liftIO (openService core s n act)

-- | One call, on a connection of its own.
requestService :: Service s => s -> ServiceName -> Request s -> Node (Either ServiceError (Response s))
requestService s name request = join <$> connected False s name ($ request)

-- | Calls on one connection, one after the other, for as long as the action takes.
withServiceConnection :: Service s => s -> ServiceName -> ((Request s -> IO (Either ServiceError (Response s))) -> IO a) -> Node (Either ServiceError a)
withServiceConnection = connected True

connected :: Service s => Bool -> s -> ServiceName -> ((Request s -> IO (Either ServiceError (Response s))) -> IO a) -> Node (Either ServiceError a)
connected persistent s name use = do
  core <- askCore
  n <- resolved name
  liftIO (connectService (master core) persistent (serviceType s, serviceMd5 s) n use)

-- | Waits until a node answers for the service.
awaitService :: ServiceName -> Node ()
awaitService name = askCore >>= \core -> resolved name >>= liftIO . awaitOffered core

-- | The value of a parameter.
getParamOpt :: Param a => ParamName -> Node (Maybe a)
getParamOpt key = do
  n <- resolved key
  asking (`Master.getParam` n) >>= traverse (readParam n)

-- | With what to take when it is not set.
getParam :: Param a => ParamName -> a -> Node a
getParam key fallback = fromMaybe fallback <$> getParamOpt key

readParam :: Param a => Name -> Value -> Node a
readParam n v = maybe (liftIO (throwIO (OtherParam n (show v)))) pure (fromValue v)

setParam :: Param a => ParamName -> a -> Node ()
setParam key x = resolved key >>= \n -> asking (\m -> Master.setParam m n (toValue x))

hasParam :: ParamName -> Node Bool
hasParam key = resolved key >>= \n -> asking (`Master.hasParam` n)

deleteParam :: ParamName -> Node ()
deleteParam key = resolved key >>= \n -> asking (`Master.deleteParam` n)

-- | The full name of the nearest parameter called so, from this node upwards.
searchParam :: ParamName -> Node (Maybe ParamName)
searchParam key = asking (`Master.searchParam` key)

-- | The value now, if it is set, and every change of it.
watchParam :: Param a => ParamName -> Node (Topic IO a)
watchParam key = do
  core <- askCore
  n <- resolved key
  changes <- liftIO newTQueueIO
  liftIO (atomically (modifyTVar' (paramWatchers core) (Map.insertWith (++) n [writeTQueue changes])))
  now <- asking (`Master.subscribeParam` n)
  liftIO (atomically (unGetTQueue changes now))
  pure (Topic.catMaybes (fmap fromValue (Topic.repeatM (atomically (readTQueue changes)))))

asking :: (Master.Master -> IO (Either RpcError b)) -> Node b
asking question = do
  core <- askCore
  liftIO (question (master core) >>= either (throwIO . NoMaster . explainRpcError) pure)

-- | Absolute, with its namespace.
getName :: Node Name
getName = ownName . coreNaming <$> askCore

getNamespace :: Node Name
getNamespace = namespace . coreNaming <$> askCore

-- | The program's own arguments: without remappings.
getArguments :: Node [String]
getArguments = Node (asks (plain . arguments . envSettings))

-- | An action that ends the node.
getShutdownAction :: Node (IO ())
getShutdownAction = (`requestEnd` Finished) <$> askCore

-- | The time that ROS has: the system's, or @/clock@ when @/use_sim_time@ is set.
getClock :: Node (IO ROSTime)
getClock = do
  simulated <- getParam "/use_sim_time" False
  if not simulated
    then pure (fromSeconds . realToFrac <$> getPOSIXTime)
    else do
      now <- liftIO (newTVarIO (fromSeconds 0))
      ticks <- subscribeBuffered 1 "/clock"
      runHandler_ (atomically . writeTVar now . Clock._clock) ticks
      pure (readTVarIO now)
