-- |
-- Description : Services among real nodes: rospy's, roscpp's and ROS's tools' on one side, ours on the other.
module Test.Ros.Services (stories) where

import Control.Concurrent.Async (forConcurrently, wait, withAsync)
import Control.Concurrent.STM
import Control.Exception (ErrorCall (..), bracket, throwIO, try)
import Control.Monad (forM_, (>=>))
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Data.List (isInfixOf)
import Network.Socket (close)
import Network.Socket.ByteString (recv, sendAll)
import Ros.Logging
import Ros.Message (encode)
import Ros.Net.Rpc (connectTo)
import Ros.Net.Tcpros
import Ros.Node
import Ros.Node.Core (Core (..))
import Ros.Roscpp.GetLoggers (GetLoggers (..))
import Ros.Roscpp.GetLoggersRequest (GetLoggersRequest (..))
import Ros.Roscpp.GetLoggersResponse (GetLoggersResponse (..))
import qualified Ros.Roscpp.Logger as Logger
import qualified Ros.Std_msgs.String as Ros
import Ros.Std_srvs.SetBool (SetBool (..))
import Ros.Std_srvs.SetBoolRequest (SetBoolRequest (..))
import Ros.Std_srvs.SetBoolResponse (SetBoolResponse (..))
import Ros.Std_srvs.Trigger (Trigger (..))
import Ros.Std_srvs.TriggerRequest (TriggerRequest (..))
import Ros.Std_srvs.TriggerResponse (TriggerResponse (..))
import System.Exit (ExitCode (..))
import Test.Ros.Peer
import Test.Tasty.HUnit

stories :: [(String, Ros -> IO ())]
stories =
  [ ("rospy and ROS's tools call its services", theyCallUs),
    ("it calls rospy's services, and each failure is a value", weCallThem),
    ("it calls roscpp's services", weCallRoscpp),
    ("roscpp calls its service", roscppCallsUs),
    ("its services answer many callers at once, and callers that say garbage or too much", manyCallers),
    ("a service is waited for, and gone when its node ends", waitsAndLeaves),
    ("its loggers are listed, and their level is set from outside", loggers)
  ]

node :: Ros -> String -> Node a -> IO a
node ros = withNodeIn (settingsFor ros [])

-- | Agrees to true, refuses false.
agree :: SetBoolRequest -> IO (Either String SetBoolResponse)
agree (SetBoolRequest b) = pure (if b then Right (SetBoolResponse True "gr\252n") else Left "false is not for m\233")

theyCallUs :: Ros -> IO ()
theyCallUs ros = withPeer ros "caller" $ \peer -> node ros "server" $ do
  offerService SetBool "switch" agree
  offerService Trigger "~broken" (const (throwIO (ErrorCall "the handler threw")))
  twice <- nodeIO (\run -> try (run (offerService Trigger "switch" (const (pure (Left ""))))))
  awaitService "~set_logger_level"
  liftIO $ do
    either Just (const Nothing) twice @?= Just (TwoServices "/switch")
    let calls what = say peer ("call " ++ what)
    calls "/switch std_srvs/SetBool {\"data\":true}"
    hears peer "answer" >>= (@?= "answer {\"success\": true, \"message\": \"gr\\u00fcn\"}")
    calls "/switch std_srvs/SetBool {\"data\":true} {\"data\":false} {\"data\":true}"
    _ <- hears peer "answer"
    -- rospy shows the bytes of the reason.
    hears peer "failed" >>= \l -> assertBool l ("false is not for m\\xc3\\xa9" `isInfixOf` l)
    _ <- hears peer "answer"
    calls "/server/broken std_srvs/Trigger {}"
    hears peer "failed" >>= \l -> assertBool l ("the handler threw" `isInfixOf` l)
    calls "/switch std_srvs/Trigger {}"
    hears peer "failed" >>= \l -> assertBool l ("std_srvs/SetBool" `isInfixOf` l)
    tool ros "rosservice" ["list"] ["/switch", "/server/broken", "/server/get_loggers", "/server/set_logger_level"]
    tool ros "rosservice" ["type", "/switch"] ["std_srvs/SetBool"]
    tool ros "rosservice" ["info", "/switch"] ["Node: /server", "URI: rosrpc://127.0.0.1:", "Type: std_srvs/SetBool", "Args: data"]
    tool ros "rosservice" ["call", "/switch", "true"] ["success: True"]
    tool ros "rosnode" ["info", "/server"] ["* /switch", "* /server/get_loggers"]

weCallThem :: Ros -> IO ()
weCallThem ros = withPeer ros "server" $ \peer -> node ros "caller" $ do
  none <- requestService SetBool "/theirs" (SetBoolRequest True)
  liftIO $ do
    none @?= Left (NoSuchService "/theirs")
    say peer "serve /theirs"
    say peer "serve /stuck"
    _ <- hears peer "serving /stuck"
    pure ()
  yes <- requestService SetBool "theirs" (SetBoolRequest True)
  no <- requestService SetBool "theirs" (SetBoolRequest False)
  other <- requestService Trigger "theirs" TriggerRequest
  several <- withServiceConnection SetBool "theirs" (\ask -> mapM (ask . SetBoolRequest) [True, False, True])
  liftIO $ do
    yes @?= Right (SetBoolResponse True "gr\252n")
    failed no
    other @?= Left (OtherService ("std_srvs/SetBool", "09fb03525b03e7ea1fd3992bafd87e16") ("std_srvs/Trigger", "937c9679a518e3a18d831e57125ea522"))
    case several of
      Right [Right a, b, Right c] -> mapM_ (@?= SetBoolResponse True "gr\252n") [a, c] >> failed b
      _ -> assertFailure (show several)
  -- The node of the service ends before it answers, and after it is known.
  cut <- nodeIO $ \run -> withAsync (run (requestService SetBool "/stuck" (SetBoolRequest True))) $ \waiting -> do
    _ <- hears peer "asked /stuck"
    killPeer peer
    wait waiting
  gone <- requestService SetBool "/stuck" (SetBoolRequest True)
  liftIO (mapM_ isLost [cut, gone])
  where
    failed answer = case answer of
      Left (ServiceFailed why) -> assertBool why ("false is not for me" `isInfixOf` why)
      _ -> assertFailure (show answer)
    isLost answer = case answer of
      Left (ConnectionLost _) -> pure ()
      _ -> assertFailure (show answer)

-- | topic_tools/MuxSelect: a string each way, which has the bytes of a std_msgs/String.
data MuxSelect = MuxSelect

instance Service MuxSelect where
  type Request MuxSelect = Ros.String
  type Response MuxSelect = Ros.String
  serviceType _ = "topic_tools/MuxSelect"
  serviceMd5 _ = "053052240ca985e1f2eedbb0dae9b1f7"

-- | roscpp's multiplexer answers with the topic that it has let through so far, or that it knows no such topic.
weCallRoscpp :: Ros -> IO ()
weCallRoscpp ros = withProgram ros "/usr/lib/topic_tools/mux" ["/out", "/first", "/second", "__name:=chooser"] $ \_ -> node ros "caller" $ do
  mapM_ awaitService ["/mux/select", "/chooser/get_loggers"]
  answers <- mapM (requestService MuxSelect "/mux/select" . Ros.String) ["/second", "/first"]
  kept <- withServiceConnection MuxSelect "/mux/select" (\ask -> mapM (ask . Ros.String) ["/second", "/third", "/first"])
  other <- requestService SetBool "/mux/select" (SetBoolRequest True)
  found <- requestService GetLoggers "/chooser/get_loggers" GetLoggersRequest
  liftIO $ do
    answers @?= map (Right . Ros.String) ["/first", "/second"]
    case kept of
      Right [Right (Ros.String "/first"), Left (ServiceFailed _), Right (Ros.String "/second")] -> pure ()
      _ -> assertFailure (show kept)
    case other of
      Left (ServiceFailed why) -> assertBool why ("md5" `isInfixOf` why)
      Left (OtherService _ _) -> pure ()
      _ -> assertFailure (show other)
    case found of
      Right (GetLoggersResponse loggers') -> assertBool (show loggers') (any (("ros.roscpp" ==) . Logger._name) loggers')
      _ -> assertFailure (show found)

-- | roscpp's program for a multiplexer, whose service is ours here: it says what the answer was, or that there was none.
roscppCallsUs :: Ros -> IO ()
roscppCallsUs ros = node ros "chooser" $ do
  asked <- liftIO (newTVarIO [])
  offerService MuxSelect "/out_select" $ \(Ros.String topic) -> do
    atomically (modifyTVar' asked (topic :))
    pure (if topic == "/second" then Right (Ros.String "/first") else Left "there is no such topic")
  awaitService "/out_select"
  liftIO $ do
    forM_ [("/second", ExitSuccess), ("/third", ExitFailure 1)] $ \(topic, ends) ->
      withProgram ros "/usr/lib/topic_tools/switch_mux" ["/out", topic] (exitOf >=> (@?= ends))
    readTVarIO asked >>= (@?= ["/third", "/second"])

manyCallers :: Ros -> IO ()
manyCallers ros = node ros "server" $ do
  offerService SetBool "switch" agree
  core <- askCore
  answers <- nodeIO $ \run -> forConcurrently [1 .. 40 :: Int] $ \n -> run (requestService SetBool "/switch" (SetBoolRequest (even n)))
  liftIO $ do
    answers @?= [if even n then Right (SetBoolResponse True "gr\252n") else Left (ServiceFailed "false is not for m\233") | n <- [1 .. 40 :: Int]]
    let header fields = frame (encodeFields fields)
        right = [("callerid", "/x"), ("service", "/switch"), ("md5sum", "*")]
        says bytes = bracket (connectTo "127.0.0.1" (coreTcpPort core)) close $ \s -> sendAll s bytes >> untilClosed s
    -- Nothing after the header but an end, a length of four billion, a request that is none: closed, closed, refused.
    says (header right <> B.replicate 4 255) >>= \b -> assertBool "a header" (B.length b > 4)
    said <- says (header right <> B.pack [3, 0, 0, 0, 1, 2, 3])
    assertBool "the request cannot be read" (C.pack "the request cannot be read" `B.isInfixOf` said)
    said' <- says (header (("probe", "1") : right))
    assertBool "a probe is answered with the sum" (C.pack "09fb03525b03e7ea1fd3992bafd87e16" `B.isInfixOf` said')
    said'' <- says (header [("callerid", "/x"), ("service", "/none"), ("md5sum", "*")])
    assertBool "no such service" (C.pack "/none is not offered here" `B.isInfixOf` said'')
    -- The request may come with the header.
    together <- says (header right <> B.pack [1, 0, 0, 0] <> encode (SetBoolRequest True))
    assertBool "answered at once" (B.cons 1 (B.pack [10, 0, 0, 0]) `B.isInfixOf` together)
  again <- requestService SetBool "/switch" (SetBoolRequest True)
  liftIO (again @?= Right (SetBoolResponse True "gr\252n"))
  where
    untilClosed s = recv s 4096 >>= \b -> if B.null b then pure b else (b <>) <$> untilClosed s

waitsAndLeaves :: Ros -> IO ()
waitsAndLeaves ros = node ros "caller" $ do
  answered <- nodeIO $ \run -> withAsync (run (awaitService "late" >> requestService Trigger "late" TriggerRequest)) $ \waiting ->
    node ros "late_server" $ offerService Trigger "late" (const (pure (Right (TriggerResponse True "here")))) >> liftIO (wait waiting)
  liftIO (answered @?= Right (TriggerResponse True "here"))
  after <- requestService Trigger "late" TriggerRequest
  liftIO (after @?= Left (NoSuchService "/late"))

loggers :: Ros -> IO ()
loggers ros = withPeer ros "listener" $ \peer -> do
  say peer "rosout"
  _ <- hears peer "listening"
  node ros "talker" $ do
    out <- enableLogging Nothing
    awaitListeners 10000000
    mapM_ awaitService ["~get_loggers", "~set_logger_level"]
    liftIO $ do
      tool ros "rosservice" ["call", "/talker/get_loggers"] ["name: \"ros\"", "level: \"debug\""]
      logTo out Debug "first"
      _ <- hearsWhere peer "first" ("first" `isInfixOf`)
      tool ros "rosservice" ["call", "/talker/set_logger_level", "ros", "warn"] []
      tool ros "rosservice" ["call", "/talker/get_loggers"] ["level: \"warn\""]
      logTo out Info "second"
      logTo out Warn "third"
      l <- hearsWhere peer "the next message" ("log /talker" `isInfixOf`)
      assertBool l ("third" `isInfixOf` l)
      tool ros "rosservice" ["call", "/talker/set_logger_level", "ros", "loud"] ["is no level"]
      tool ros "rosservice" ["call", "/talker/set_logger_level", "other", "warn"] ["there is no logger"]
