-- |
-- Module      : Ros.Node.Core
-- Description : What a running node is made of.
--
-- The state that publications, subscriptions, the answering server and the end of the node share. Each
-- part that runs is a thread that the node knows and ends. Nothing here opens a connection.
module Ros.Node.Core
  ( -- * The node
    Core (..),
    Ending (..),
    NodeError (..),
    explainNodeError,
    requestEnd,
    master,

    -- * Its topics
    Publication (..),
    Outlet (..),
    Subscription (..),
    Inlet (..),

    -- * Its services
    Offered (..),

    -- * Its threads
    spawn,
    spawnLinked,
    stopAll,
    freshId,
    complain,
  )
where

import Control.Concurrent.Async (Async, asyncWithUnmask, cancel)
import Control.Concurrent.MVar (MVar)
import Control.Concurrent.STM
import Control.Exception
import Control.Monad (unless, void)
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.Map.Strict as Map
import qualified Data.Text as T
import qualified Data.Text.Encoding as T
import Data.Word (Word32)
import Network.Socket (Socket)
import Ros.LogLevel (LogLevel)
import Ros.Names (Naming (..))
import Ros.Net.Master (Master (..))
import Ros.Net.Rpc (Uri)
import Ros.Net.Tcpros (Offer)
import Ros.Net.XmlRpc (Value)
import Ros.Queue (Queue)
import System.IO (stderr)

data Core = Core
  { coreNaming :: Naming,
    coreMaster :: Uri,
    -- | where this node answers calls
    coreUri :: Uri,
    coreHost :: String,
    coreTcpPort :: Int,
    coreProgramName :: String,
    publications :: TVar (Map.Map String Publication),
    subscriptions :: TVar (Map.Map String Subscription),
    services :: TVar (Map.Map String Offered),
    -- | what is less grave is not logged
    logLevel :: TVar LogLevel,
    paramWatchers :: TVar (Map.Map String [Value -> STM ()]),
    -- | the master has not heard of all topics
    unregistered :: TVar Bool,
    ending :: TMVar Ending,
    threads :: TVar (Map.Map Int (Async ())),
    counter :: TVar Int
  }

-- | Why a node ends.
data Ending
  = -- | Its program said so, or has nothing more to do.
    Finished
  | -- | Ctrl-C, or the system asks it to stop.
    Interrupted
  | -- | The master or another node asked, for this reason; a new node of the same name is one.
    AskedTo String
  | -- | A part of the program failed.
    Failed SomeException

data NodeError
  = -- | One node uses a topic with two types: topic, the type there, the type asked for.
    TwoTypes String String String
  | -- | One node offers two services of this name.
    TwoServices String
  | -- | @ROS_MASTER_URI@ or @__master@ cannot be read.
    StrangeMaster String
  | -- | A parameter that is not set and has no default.
    NoParam String
  | -- | A parameter of another type: name and value.
    OtherParam String String
  | -- | The master could not be asked.
    NoMaster String
  deriving (Eq, Show)

instance Exception NodeError where
  displayException = explainNodeError

explainNodeError :: NodeError -> String
explainNodeError e = case e of
  TwoTypes topic old new -> "The topic " ++ topic ++ " carries " ++ old ++ " in this node. It cannot carry " ++ new ++ " too."
  TwoServices n -> "This node offers the service " ++ n ++ " already."
  StrangeMaster t -> "\"" ++ t ++ "\" is not the address of a ROS master. It looks like http://localhost:11311."
  NoParam n -> "The parameter " ++ n ++ " is not set."
  OtherParam n v -> "The parameter " ++ n ++ " is " ++ v ++ ", which is of another type than the program expects."
  NoMaster why -> "The ROS master could not be asked: " ++ why ++ "."

-- | The first reason counts.
requestEnd :: Core -> Ending -> IO ()
requestEnd core why = void (atomically (tryPutTMVar (ending core) why))

master :: Core -> Master
master core = Master (coreMaster core) (ownName (coreNaming core)) (coreUri core)

-- | A topic this node publishes.
data Publication = Publication
  { pubOffer :: Offer,
    pubLatched :: Bool,
    -- | for late subscribers, when latched; the bytes are chosen when they are sent
    pubLast :: TVar (Maybe (IO ByteString)),
    -- | the sequence number of the next message
    pubNext :: TVar Word32,
    pubOutlets :: TVar (Map.Map Int Outlet),
    pubBound :: TVar Int,
    -- | runs the exchange with a subscriber
    pubAround :: Socket -> IO () -> IO ()
  }

-- | A connection to one subscriber.
data Outlet = Outlet
  { outletPeer :: String,
    outletSocket :: Socket,
    -- | messages whose bytes are chosen when they are sent
    outletQueue :: Queue (IO ByteString),
    -- | bytes are on their way to the system
    outletBusy :: TVar Bool,
    -- | what the system did not take of a message
    outletRest :: TVar ByteString,
    -- | messages and bytes
    outletSent :: TVar (Int, Int)
  }

-- | A topic this node listens to: who publishes it, and the queues that want its messages.
data Subscription = Subscription
  { subOffer :: Offer,
    subPublishers :: TVar (Map.Map Uri Inlet),
    subSinks :: TVar [ByteString -> STM ()],
    -- | held while the list of publishers changes, so that an older list never comes after a newer one
    subTurn :: MVar ()
  }

-- | A connection to one publisher, or the attempt to have one.
data Inlet = Inlet
  { inletId :: Int,
    inletThread :: Async (),
    inletConnected :: TVar Bool,
    inletReceived :: TVar (Int, Int)
  }

-- | A service this node offers: its type and sum, those of its two messages' types, and what makes a response of a request.
data Offered = Offered
  { offeredType :: String,
    offeredMd5 :: String,
    offeredRequest :: String,
    offeredResponse :: String,
    -- | bytes of a request to bytes of the response, or why there is none
    offeredAnswer :: ByteString -> IO (Either String ByteString)
  }

freshId :: Core -> IO Int
freshId core = atomically (stateTVar (counter core) (\n -> (n, n + 1)))

-- | A thread that lives no longer than the node, and can be ended also when its starter cannot.
spawn :: Core -> IO () -> IO (Async ())
spawn core act = mask_ $ do
  n <- freshId core
  ready <- newEmptyTMVarIO
  a <- asyncWithUnmask (\unmask -> atomically (readTMVar ready) >> unmask act `finally` atomically (modifyTVar' (threads core) (Map.delete n)))
  atomically (modifyTVar' (threads core) (Map.insert n a) >> putTMVar ready ())
  pure a

-- | As 'spawn'; when the thread fails, the node ends and says why.
spawnLinked :: Core -> IO () -> IO (Async ())
spawnLinked core act = spawn core (act `catch` report)
  where
    report e = case fromException e of
      Just asynchronous -> throwIO (asynchronous :: SomeAsyncException)
      Nothing -> requestEnd core (Failed e)

-- | Ends every thread of the node but the caller's, and waits until they have ended.
stopAll :: Core -> IO ()
stopAll core = do
  running <- readTVarIO (threads core)
  mapM_ cancel running
  left <- readTVarIO (threads core)
  unless (Map.null (Map.difference left running)) (stopAll core)

-- | For the person at the terminal.
complain :: Core -> String -> IO ()
complain core message = B.hPut stderr (T.encodeUtf8 (T.pack (ownName (coreNaming core) ++ ": " ++ message ++ "\n")))
