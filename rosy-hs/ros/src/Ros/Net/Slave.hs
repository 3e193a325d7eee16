-- |
-- Module      : Ros.Net.Slave
-- Description : What a node answers when the master or another node calls.
--
-- In: a call, and what there is to know about this node. Out: the answer, and what the call makes the
-- node do. Pure: "Ros.Node.Run" carries out the effects after it has answered, since a caller waits.
-- The calls are those of <http://wiki.ros.org/ROS/Slave_API>.
module Ros.Net.Slave
  ( Slave (..),
    Connection (..),
    Direction (..),
    Effect (..),
    answerCall,
  )
where

import Data.Maybe (mapMaybe)
import Ros.Net.Rpc (Uri (..), readUri, showUri)
import Ros.Net.XmlRpc

-- | A node as its peers see it.
data Slave = Slave
  { slavePid :: Int,
    slaveMaster :: Uri,
    slaveHost :: String,
    -- | of TCPROS
    slavePort :: Int,
    -- | topic and type
    published :: [(String, String)],
    subscribed :: [(String, String)],
    connections :: [Connection]
  }

data Direction = Inbound | Outbound
  deriving (Eq, Show)

data Connection = Connection
  { connectionId :: Int,
    -- | a node's name, or for an inbound connection where that node's server is
    connectionPeer :: String,
    connectionDirection :: Direction,
    connectionTopic :: String,
    connectionMessages :: Int,
    connectionBytes :: Int
  }
  deriving (Eq, Show)

data Effect
  = -- | Exactly these publish the topic now.
    PublishersAre String [Uri]
  | -- | The node must end; the caller's reason.
    EndBecause String
  | ParamIs String Value
  deriving (Eq, Show)

answerCall :: Slave -> Call -> (Answer, [Effect])
answerCall s (Call method args) = case (method, drop 1 args) of
  ("publisherUpdate", [VString topic, VArray us])
    | topic `elem` map fst (subscribed s) -> (good (VInt 0), [PublishersAre topic (mapMaybe peer us)])
    | otherwise -> (good (VInt 0), []) -- the master may be late: we have unsubscribed meanwhile
  ("requestTopic", [VString topic, VArray protocols])
    | topic `notElem` map fst (published s) -> (answer (-1) (topic ++ " is not published here") (VInt 0), [])
    | "TCPROS" `elem` [p | VArray (VString p : _) <- protocols] ->
      (answer 1 ("ready on " ++ slaveHost s ++ ":" ++ show (slavePort s)) (VArray [VString "TCPROS", VString (slaveHost s), VInt (slavePort s)]), [])
    | otherwise -> (answer 0 "only TCPROS is spoken here" (VArray []), [])
  ("shutdown", why) -> (good (VInt 0), [EndBecause (case why of VString w : _ | not (null w) -> w; _ -> "another node asked for it")])
  ("paramUpdate", [VString key, v]) -> (good (VInt 0), [ParamIs key v])
  ("getPid", _) -> (good (VInt (slavePid s)), [])
  ("getMasterUri", _) -> (good (VString (showUri (slaveMaster s))), [])
  ("getPublications", _) -> (good (pairs (published s)), [])
  ("getSubscriptions", _) -> (good (pairs (subscribed s)), [])
  ("getBusInfo", _) -> (good (VArray (map busInfo (connections s))), [])
  ("getBusStats", _) -> (good (busStats s), [])
  ("system.listMethods", _) -> (Answer (VArray (map VString methods)), [])
  (m, _)
    | m `elem` methods -> (answer (-1) (m ++ ": these are not its arguments") (VInt 0), [])
    | otherwise -> (Fault ("method \"" ++ m ++ "\" is not supported"), [])
  where
    peer (VString u) = readUri u
    peer _ = Nothing
    pairs ps = VArray [VArray [VString t, VString k] | (t, k) <- ps]

methods :: [String]
methods =
  ["publisherUpdate", "requestTopic", "shutdown", "paramUpdate", "getPid", "getMasterUri"]
    ++ ["getPublications", "getSubscriptions", "getBusInfo", "getBusStats", "system.listMethods"]

good :: Value -> Answer
good = answer 1 ""

answer :: Int -> String -> Value -> Answer
answer code message v = Answer (VArray [VInt code, VString message, v])

-- | @[id, peer, direction, transport, topic, connected]@
busInfo :: Connection -> Value
busInfo c =
  VArray
    [ VInt (connectionId c),
      VString (connectionPeer c),
      VString (case connectionDirection c of Inbound -> "i"; Outbound -> "o"),
      VString "TCPROS",
      VString (connectionTopic c),
      VBool True
    ]

-- | @[publishers, subscribers, services]@, per topic the bytes and messages of every connection.
busStats :: Slave -> Value
busStats s = VArray [VArray (map sent (published s)), VArray (map received (subscribed s)), VArray []]
  where
    sent (t, _) = VArray [VString t, VInt (sum (map connectionBytes (on Outbound t))), VArray (map outgoing (on Outbound t))]
    received (t, _) = VArray [VString t, VArray (map incoming (on Inbound t))]
    outgoing c = VArray [VInt (connectionId c), VInt (connectionBytes c), VInt (connectionMessages c), VBool True]
    incoming c = VArray [VInt (connectionId c), VInt (connectionBytes c), VInt (connectionMessages c), VInt (-1), VBool True] -- -1: drops not known
    on d t = [c | c <- connections s, connectionDirection c == d, connectionTopic c == t]
