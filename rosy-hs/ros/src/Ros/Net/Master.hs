-- |
-- Module      : Ros.Net.Master
-- Description : The questions a node asks its master, and the parameter server.
--
-- In: who asks and what about. Out: the master's answer. Each is one XML-RPC call of
-- <http://wiki.ros.org/ROS/Master_API> or @Parameter Server API@; every answer there is
-- @[code, message, value]@.
module Ros.Net.Master
  ( Master (..),
    registerPublisher,
    unregisterPublisher,
    registerSubscriber,
    unregisterSubscriber,
    lookupNode,
    lookupService,
    registerService,
    unregisterService,
    getParam,
    setParam,
    hasParam,
    deleteParam,
    searchParam,
    subscribeParam,
    unsubscribeParam,
    getParamNames,
    allSubscribers,
    topicTypes,
    nodeAnswers,
    ask,
  )
where

import Data.Maybe (mapMaybe)
import Ros.Net.Rpc
import Ros.Net.XmlRpc

-- | Where the master is, who asks, and where that node's own server is.
data Master = Master {masterUri :: Uri, caller :: String, callerUri :: Uri}

-- | Gives the value, or what the master said instead.
ask :: Master -> String -> [Value] -> IO (Either RpcError Value)
ask m method args = status <$> call (masterUri m) (Call method (VString (caller m) : args))
  where
    status r =
      r >>= \case
        VArray [VInt 1, _, x] -> Right x
        VArray [VInt _, VString why, _] -> Left (Refused why)
        other -> Left (Garbled (masterUri m) (show other))

registerPublisher :: Master -> String -> String -> IO (Either RpcError ())
registerPublisher m topic kind = nothing <$> ask m "registerPublisher" [VString topic, VString kind, self m]

unregisterPublisher :: Master -> String -> IO (Either RpcError ())
unregisterPublisher m topic = nothing <$> ask m "unregisterPublisher" [VString topic, self m]

-- | Gives who publishes the topic now.
registerSubscriber :: Master -> String -> String -> IO (Either RpcError [Uri])
registerSubscriber m topic kind = fmap uris <$> ask m "registerSubscriber" [VString topic, VString kind, self m]

unregisterSubscriber :: Master -> String -> IO (Either RpcError ())
unregisterSubscriber m topic = nothing <$> ask m "unregisterSubscriber" [VString topic, self m]

-- | Where a node's own server is.
lookupNode :: Master -> String -> IO (Either RpcError (Maybe Uri))
lookupNode m n = fmap uri <$> ask m "lookupNode" [VString n]

lookupService :: Master -> String -> IO (Either RpcError (Maybe Uri))
lookupService m n = fmap uri <$> ask m "lookupService" [VString n]

-- | The address is that of the node's connections, not of its calls.
registerService :: Master -> String -> Uri -> IO (Either RpcError ())
registerService m n at = nothing <$> ask m "registerService" [VString n, VString (serviceUri at), self m]

unregisterService :: Master -> String -> Uri -> IO (Either RpcError ())
unregisterService m n at = nothing <$> ask m "unregisterService" [VString n, VString (serviceUri at)]

serviceUri :: Uri -> String
serviceUri (Uri host port) = "rosrpc://" ++ host ++ ":" ++ show port

-- | Nothing when the parameter is not set.
getParam :: Master -> String -> IO (Either RpcError (Maybe Value))
getParam m key =
  hasParam m key >>= \case
    Right True -> fmap Just <$> ask m "getParam" [VString key]
    Right False -> pure (Right Nothing)
    Left e -> pure (Left e)

setParam :: Master -> String -> Value -> IO (Either RpcError ())
setParam m key v = nothing <$> ask m "setParam" [VString key, v]

hasParam :: Master -> String -> IO (Either RpcError Bool)
hasParam m key = fmap truth <$> ask m "hasParam" [VString key]
  where
    truth v = v == VBool True || v == VInt 1

deleteParam :: Master -> String -> IO (Either RpcError ())
deleteParam m key = nothing <$> ask m "deleteParam" [VString key]

-- | The nearest parameter of this name, from the caller's namespace upwards.
searchParam :: Master -> String -> IO (Either RpcError (Maybe String))
searchParam m key = fmap found <$> ask m "searchParam" [VString key]
  where
    found (VString n) | not (null n) = Just n
    found _ = Nothing

-- | The value now, and from now on a @paramUpdate@ when it changes.
subscribeParam :: Master -> String -> IO (Either RpcError Value)
subscribeParam m key = ask m "subscribeParam" [self m, VString key]

unsubscribeParam :: Master -> String -> IO (Either RpcError ())
unsubscribeParam m key = nothing <$> ask m "unsubscribeParam" [self m, VString key]

getParamNames :: Master -> IO (Either RpcError [String])
getParamNames m = fmap names <$> ask m "getParamNames" []
  where
    names (VArray vs) = [n | VString n <- vs]
    names _ = []

-- | Every topic with subscribers, with the names of those nodes.
allSubscribers :: Master -> IO (Either RpcError [(String, [String])])
allSubscribers m = fmap listed <$> ask m "getSystemState" []
  where
    listed v = case v of
      VArray [_, VArray topics, _] -> [(topic, [n | VString n <- nodes]) | VArray [VString topic, VArray nodes] <- topics]
      _ -> []

-- | The type of every topic that the master knows.
topicTypes :: Master -> IO (Either RpcError [(String, String)])
topicTypes m = fmap listed <$> ask m "getTopicTypes" []
  where
    listed v = case v of
      VArray topics -> [(topic, kind) | VArray [VString topic, VString kind] <- topics]
      _ -> []

-- | Whether a node of this name answers: the master keeps those that were killed.
nodeAnswers :: Master -> String -> IO Bool
nodeAnswers m name =
  lookupNode m name >>= \case
    Right (Just at) -> either (const False) (const True) <$> call at (Call "getPid" [VString (caller m)])
    _ -> pure False

self :: Master -> Value
self = VString . showUri . callerUri

nothing :: Either RpcError a -> Either RpcError ()
nothing = (() <$)

uri :: Value -> Maybe Uri
uri (VString s) = readUri s
uri _ = Nothing

uris :: Value -> [Uri]
uris (VArray vs) = mapMaybe uri vs
uris _ = []
