{-# LANGUAGE FlexibleContexts #-}

-- |
-- Module      : Ros.Node.Service
-- Description : Services that this node offers, and calls of other nodes' services.
--
-- A service's connection is one of TCPROS: the caller says in its header which service it means and by which sum it knows it, and the
-- server answers with its own header. Then come a request and its response, once or, on a persistent connection, as often as the caller
-- likes. A response begins with a byte that says whether it is one or the reason why there is none
-- (<http://wiki.ros.org/ROS/TCPROS>, roscpp's @service_client_link.cpp@, rospy's @tcpros_service.py@).
module Ros.Node.Service
  ( openService,
    registerOffered,
    unregisterOffered,
    serviceAddress,
    loggersService,
    serveCaller,
    serveConnection,
    connectService,
    awaitOffered,
    loggerServices,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.STM
import Control.Exception
import Control.Monad (unless, void, when)
import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as B
import Data.Char (toLower)
import Data.IORef
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy (..))
import qualified Data.Text as T
import qualified Data.Text.Encoding as T
import qualified Data.Text.Encoding.Error as T
import Network.Socket (Socket, close)
import Network.Socket.ByteString (recv, sendAll)
import Ros.LogLevel
import Ros.Message
import Ros.Names (Naming (..), resolve)
import qualified Ros.Net.Master as Master
import Ros.Net.Rpc
import Ros.Net.Tcpros
import Ros.Node.Core
import Ros.Node.Publish (serveSubscriber)
import Ros.Roscpp.GetLoggers (GetLoggers (..))
import Ros.Roscpp.GetLoggersResponse (GetLoggersResponse (..))
import Ros.Roscpp.Logger (Logger (..))
import Ros.Roscpp.SetLoggerLevel (SetLoggerLevel (..))
import Ros.Roscpp.SetLoggerLevelRequest (SetLoggerLevelRequest (..))
import Ros.Roscpp.SetLoggerLevelResponse (SetLoggerLevelResponse (..))
import Ros.Service.Class

-- | Offers a service from now on. A handler that throws has failed for its caller alone.
openService :: forall s. Service s => Core -> s -> String -> (Request s -> IO (Either String (Response s))) -> IO ()
openService core s name act = do
  atomically $ do
    known <- readTVar (services core)
    when (name `Map.member` known) (throwSTM (TwoServices name))
    writeTVar (services core) (Map.insert name (offered s act) known)
  registerOffered core name

offered :: forall s. Service s => s -> (Request s -> IO (Either String (Response s))) -> Offered
offered s act =
  Offered
    { offeredType = serviceType s,
      offeredMd5 = serviceMd5 s,
      offeredRequest = messageType (Proxy :: Proxy (Request s)),
      offeredResponse = messageType (Proxy :: Proxy (Response s)),
      offeredAnswer = \bytes -> case decode bytes of
        Left why -> pure (Left ("the request cannot be read: " ++ show why))
        Right request -> (act request >>= traverse (evaluate . encode)) `catch` failed
    }
  where
    failed :: SomeException -> IO (Either String B.ByteString)
    failed e@(SomeException thrown) = case fromException e of
      Just asynchronous -> throwIO (asynchronous :: SomeAsyncException)
      -- Not the text of SomeException, to which GHC 9.10 adds a backtrace.
      Nothing -> pure (Left (displayException thrown))

-- | Tells the master. When it cannot be told now, "Ros.Node.Run" tells it later.
registerOffered :: Core -> String -> IO ()
registerOffered core name = Master.registerService (master core) name (serviceAddress core) >>= either (const (atomically (writeTVar (unregistered core) True))) pure

unregisterOffered :: Core -> String -> IO ()
unregisterOffered core name = void (Master.unregisterService (master core) name (serviceAddress core))

-- | Where callers connect.
serviceAddress :: Core -> Uri
serviceAddress core = Uri (coreHost core) (coreTcpPort core)

-- | A connection of another node: a subscriber or a caller, as its header says.
serveConnection :: Core -> Socket -> IO ()
serveConnection core s = do
  header <- receiveHeader s
  case header of
    Left _ -> pure ()
    Right bytes -> case decodeFields bytes of
      Left why -> sendAll s (frame (encodeFields (errorFields (TheyRefuse why))))
      Right theirs
        | Just name <- lookup "service" theirs -> serveCaller core s name theirs
        | otherwise -> serveSubscriber core s theirs

-- | A header is a few hundred bytes and a message definition.
maxHeader :: Int
maxHeader = 1024 * 1024

-- | One caller, from its header until it leaves.
serveCaller :: Core -> Socket -> String -> Fields -> IO ()
serveCaller core s name theirs = do
  known <- readTVarIO (services core)
  case agreed known of
    Left why -> sendAll s (frame (encodeFields (errorFields why)))
    Right service -> do
      sendAll s (frame (encodeFields (header service)))
      unless (isSet "probe") $ do
        next <- frameReader maxFrame (recv s 65536)
        serveRequests service next
  where
    agreed known = do
      service <- maybe (Left (UnknownService name)) Right (Map.lookup name known)
      callerAccepted (name, offeredType service, offeredMd5 service) theirs
      pure service
    header service =
      [ ("callerid", ownName (coreNaming core)),
        ("service", name),
        ("type", offeredType service),
        ("md5sum", offeredMd5 service),
        ("request_type", offeredRequest service),
        ("response_type", offeredResponse service)
      ]
    isSet field = lookup field theirs `elem` map Just ["1", "true", "True"]
    serveRequests service next =
      next >>= \case
        Left _ -> pure ()
        Right request -> do
          offeredAnswer service request >>= sendAll s . either refusal response
          when (isSet "persistent") (serveRequests service next)
    response bytes = B.cons 1 (frame (B.byteString bytes))
    refusal why = B.cons 0 (frame (B.byteString (T.encodeUtf8 (T.pack why))))

-- | Pieces with a length, one after the other; or why there are no more.
frameReader :: Int -> IO B.ByteString -> IO (IO (Either String B.ByteString))
frameReader limit receive = do
  state <- newIORef ([], noBytes)
  let next =
        readIORef state >>= \case
          (f : fs, rest) -> Right f <$ writeIORef state (fs, rest)
          ([], rest) -> do
            more <- receive
            if B.null more
              then pure (Left "it closed the connection")
              else case feed limit rest more of
                Left (TooLong n) -> pure (Left ("a piece of " ++ show n ++ " bytes"))
                Right (fs, rest') -> writeIORef state (fs, rest') >> next
  pure next

-- | Connects to the service of this name, with the type and sum that the caller knows it by, while the action runs, which gets a call. Not
-- from several threads at once.
connectService :: (RosBinary request, RosBinary response) => Master.Master -> Bool -> (String, String) -> String -> ((request -> IO (Either ServiceError response)) -> IO a) -> IO (Either ServiceError a)
connectService asker persistent (kind, sum5) name use =
  Master.lookupService asker name >>= \case
    Left (Refused _) -> pure (Left (NoSuchService name))
    Left why -> pure (Left (MasterLost (explainRpcError why)))
    Right Nothing -> pure (Left (NoSuchService name))
    Right (Just at) ->
      connecting at $ \socket -> do
        answered <- hello socket ([("callerid", Master.caller asker), ("service", name), ("md5sum", sum5), ("type", kind)] ++ [("persistent", "1") | persistent])
        case answered of
          Left why -> pure (Left why)
          Right theirs -> case lookup "error" theirs of
            Just why -> Left <$> reason at why
            Nothing
              | Just m <- lookup "md5sum" theirs, m /= sum5, m /= "*" -> pure (Left (other theirs m))
              | otherwise -> Right <$> use (request socket)
  where
    other theirs m = OtherService (fromMaybe "?" (lookup "type" theirs), m) (kind, sum5)
    -- A server says in its own words what is wrong; whether it is the sum, it says when it is asked for any.
    reason at why = do
      probed <- connecting at (\socket -> hello socket [("callerid", Master.caller asker), ("service", name), ("md5sum", "*"), ("probe", "1")])
      pure $ case probed of
        Right theirs | Just m <- lookup "md5sum" theirs, m /= sum5 -> other theirs m
        _ -> ServiceFailed why
    request socket asked = lost (sendAll socket (frame (put asked)) >> response socket)
    response socket =
      receiveExactly socket 1 >>= \case
        Left why -> pure (Left (ConnectionLost why))
        Right ok -> do
          next <- frameReader maxFrame (recv socket 65536)
          body <- next
          pure $ case body of
            Left why -> Left (ConnectionLost why)
            Right bytes
              | ok == B.singleton 0 -> Left (ServiceFailed (T.unpack (T.decodeUtf8With T.lenientDecode bytes)))
              | otherwise -> either (Left . StrangeAnswer . show) Right (decode bytes)

-- | A connection for as long as the action takes.
connecting :: Uri -> (Socket -> IO (Either ServiceError a)) -> IO (Either ServiceError a)
connecting (Uri host port) act = do
  connected <- try (connectTo host port)
  case connected of
    Left e -> pure (Left (ConnectionLost (show (e :: IOException))))
    Right socket -> act socket `finally` close socket

-- | Says this header and hears the other one.
hello :: Socket -> Fields -> IO (Either ServiceError Fields)
hello socket fields = lost $ do
  sendAll socket (frame (encodeFields fields))
  either (Left . ConnectionLost) (either (Left . StrangeAnswer) Right . decodeFields) <$> receiveHeader socket

-- | The bytes of a header, and none of those behind it.
receiveHeader :: Socket -> IO (Either String B.ByteString)
receiveHeader socket =
  receiveExactly socket 4 >>= \case
    Left why -> pure (Left why)
    Right size
      | n > maxHeader -> pure (Left ("a header of " ++ show n ++ " bytes"))
      | otherwise -> receiveExactly socket n
      where
        n = B.foldr (\byte above -> above * 256 + fromIntegral byte) 0 size

receiveExactly :: Socket -> Int -> IO (Either String B.ByteString)
receiveExactly socket = go []
  where
    go have 0 = pure (Right (B.concat (reverse have)))
    go have n = do
      more <- recv socket (min n 65536)
      if B.null more then pure (Left "it closed the connection") else go (more : have) (n - B.length more)

lost :: IO (Either ServiceError a) -> IO (Either ServiceError a)
lost act = try act >>= either (\e -> pure (Left (ConnectionLost (show (e :: IOException))))) pure

-- | Waits until a node answers for the service of this name.
awaitOffered :: Core -> String -> IO ()
awaitOffered core name = do
  there <-
    Master.lookupService (master core) name >>= \case
      Right (Just at) -> connecting at (\socket -> hello socket [("callerid", ownName (coreNaming core)), ("service", name), ("md5sum", "*"), ("probe", "1")])
      _ -> pure (Left (NoSuchService name))
  case there of
    Right theirs | "error" `notElem` map fst theirs -> pure ()
    _ -> threadDelay lookEvery >> awaitOffered core name

-- | A tenth of a second, in microseconds.
lookEvery :: Int
lookEvery = 100000

-- | The service that every node offers.
loggersService :: String
loggersService = "~get_loggers"

-- | What each node offers, as roscpp and rospy do: its loggers, of which there is one, and its level.
loggerServices :: Core -> IO ()
loggerServices core = atomically $ do
  modifyTVar' (services core) (Map.union ours)
  -- The node does not wait for the master.
  writeTVar (unregistered core) True
  where
    ours =
      Map.fromList
        [ (own loggersService, offered GetLoggers (const (Right . levels <$> readTVarIO (logLevel core)))),
          (own "~set_logger_level", offered SetLoggerLevel set)
        ]
    own = resolve (coreNaming core)
    levels level = GetLoggersResponse [Logger "ros" (map toLower (levelWord level))]
    set (SetLoggerLevelRequest logger word)
      | logger /= "ros" = pure (Left ("there is no logger \"" ++ logger ++ "\" in this node, only \"ros\""))
      | otherwise = case readLevel word of
        Nothing -> pure (Left ("\"" ++ word ++ "\" is no level; there are " ++ unwords (map levelWord [minBound ..])))
        Just level -> Right SetLoggerLevelResponse <$ atomically (writeTVar (logLevel core) level)
