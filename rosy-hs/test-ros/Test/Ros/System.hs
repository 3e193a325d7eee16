-- |
-- Description : A node among real ROS nodes.
--
-- The peers are Debian's rosmaster, rospy nodes, roscpp's relay and multiplexer, rostopic and rosnode. Where they cannot
-- be installed every test says so and passes without having tested.
module Test.Ros.System (tests, aNode, anEcho) where

import Control.Concurrent.Async (wait, withAsync)
import Control.Concurrent.STM
import Control.Exception (ErrorCall (..), bracket, throwIO, try)
import Control.Monad (forM_, void)
import qualified Data.ByteString.Char8 as C
import Data.List (isInfixOf)
import qualified Data.Map.Strict as Map
import Network.Socket (Socket, close)
import Network.Socket.ByteString (recv, sendAll)
import Ros.Geometry_msgs.Twist (Twist, linear)
import qualified Ros.Geometry_msgs.TwistWithCovariance as Covariance
import qualified Ros.Geometry_msgs.Vector3 as Vector3
import Ros.Kobuki_msgs.BumperEvent (BumperEvent (..))
import Ros.Kobuki_msgs.Led (Led (..))
import Ros.Lens
import Ros.Logging
import Ros.Message (def)
import Ros.Names (readArguments)
import Ros.Nav_msgs.Odometry (Odometry)
import qualified Ros.Nav_msgs.Odometry as Odometry
import Ros.Net.Master (lookupService, unregisterPublisher, unregisterService)
import Ros.Net.Rpc (Uri (..), call, connectTo, readUri)
import Ros.Net.Tcpros
import Ros.Net.XmlRpc (Call (..))
import Ros.Node
import Ros.Node.Core (Core (..), Publication (..), master)
import qualified Ros.Std_msgs.Int32 as Int32
import qualified Ros.Std_msgs.String as Ros
import Ros.Std_srvs.SetBool (SetBool (..))
import Ros.Std_srvs.SetBoolRequest (SetBoolRequest (..))
import Ros.Std_srvs.SetBoolResponse (SetBoolResponse (..))
import Ros.Topic (Topic (..))
import qualified Ros.Topic as T
import Ros.Topic.Util
import System.Directory (createDirectoryIfMissing, getTemporaryDirectory, removeDirectoryRecursive)
import System.Environment (getExecutablePath)
import System.Exit (ExitCode (..))
import System.IO (hFlush, stdout)
import System.Posix.Process (getProcessID)
import System.Timeout (timeout)
import Test.Ros.Hostile
import Test.Ros.Peer
import qualified Test.Ros.Services
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests = withResource acquire release $ \ready ->
  localOption (mkTimeout 900000000) . testGroup "among real nodes" $
    [ story ready "it drives a base: bumpers to LEDs, odometry to velocity" drivesABase,
      story ready "roscpp listens to it and talks to it" withRoscpp,
      story ready "when it ends, its last message arrives and the master forgets it" saysGoodbye,
      testGroup "services" [story ready name act | (name, act) <- Test.Ros.Services.stories]
    ]
      ++ [ story ready "ROS's tools see it: list, info, ping, echo" toolsSeeIt,
           story ready "publishers may come before it and after it" earlyAndLate,
           story ready "a latched message reaches those who come later, both ways" latchedBothWays,
           story ready "2,000 messages go each way without loss, in order" twoThousand,
           story ready "each reader of a subscription gets every message" twoReaders,
           story ready "a base that is killed and comes back is heard again" baseRestart,
           story ready "a slow subscriber loses the oldest, and delays no other" slowSubscriber,
           story ready "a node that takes its name ends it, and it ends one whose name it takes" nameClash,
           story ready "a node that was killed can be started again under its name" startedAgain,
           story ready "the example that prints a topic prints a bumper" printsATopic,
           story ready "the example that fuses two sensors slows down before a wall" fuses,
           story ready "parameters are shared, and changes are told" parameters,
           story ready "names are remapped, moved and given on the command line" remapped,
           story ready "it tells the address it is given: ROS_HOSTNAME, ROS_IP, __hostname, __ip" ownAddress,
           masterStory,
           story ready "what it logs is on /rosout with its place" logs,
           story ready "callers that say nothing, garbage or too much do not end it" strangeCallers,
           story ready "subscribers that say nothing, garbage or too much do not end it" strangeSubscribers,
           story ready "publishers that say nothing, garbage or too much do not end it, and it hears the others" strangePublishers,
           story ready "a subscriber of another type is refused and told why" otherType,
           story ready "one topic with two types in one node is refused" twoTypes,
           story ready "a handler that fails ends the node" handlerFails,
           story ready "Ctrl-C and the system's request end it, and the master forgets it" endsOnSignals,
           restartStory ready,
           story ready "it registers again when the master knows only what it told it last" forgotten,
           story ready "a round trip takes no longer than rospy's (printed, not judged)" roundTrip
         ]
  where
    acquire = do
      tmp <- getTemporaryDirectory
      pid <- getProcessID
      let folder = tmp ++ "/ros-test-" ++ show pid
      createDirectoryIfMissing True folder
      prepared <- withRos folder
      pure (folder, prepared)
    release (folder, _) = removeDirectoryRecursive folder

type Ready = IO (FilePath, Either String FilePath)

-- | A test with a master of its own.
story :: Ready -> String -> (Ros -> IO ()) -> TestTree
story ready name act = testCaseInfo name $ ready >>= either skip (\folder -> "" <$ withMaster folder act) . snd

skip :: String -> IO String
skip why = pure ("skipped: " ++ why)

-- | Our node, in this process, while the test runs.
node :: Ros -> String -> Node a -> IO a
node ros = withNodeIn (settingsFor ros [])

toolsSeeIt :: Ros -> IO ()
toolsSeeIt ros = node ros "walker" $ do
  advertise "/mobile_base/commands/velocity" (topicRate 50 (T.repeat (forward 0.25)))
  _ <- subscribe "/odom" :: Node (Topic IO Odometry)
  liftIO $ do
    tool ros "rosnode" ["list"] ["/walker"]
    tool ros "rosnode" ["info", "/walker"] ["* /mobile_base/commands/velocity [geometry_msgs/Twist]", "* /odom [unknown type]", "Pid:"]
    tool ros "rosnode" ["ping", "-c", "2", "/walker"] ["xmlrpc reply from"]
    tool ros "rostopic" ["list"] ["/mobile_base/commands/velocity", "/odom"]
    tool ros "rostopic" ["info", "/mobile_base/commands/velocity"] ["Type: geometry_msgs/Twist", "* /walker (http://127.0.0.1:"]
    tool ros "rostopic" ["echo", "-n", "1", "/mobile_base/commands/velocity"] ["x: 0.25"]
    withProgram ros "/usr/bin/rostopic" ["hz", "/mobile_base/commands/velocity"] (\hz -> void (hears hz "average rate: "))

forward :: Double -> Twist
forward v = def & linear . Vector3.x .~ v

drivesABase :: Ros -> IO ()
drivesABase ros = withPeer ros "mobile_base" $ \base -> do
  mapM_ (say base) ["pub /mobile_base/events/bumper kobuki_msgs/BumperEvent", "pub /odom nav_msgs/Odometry", "sub /mobile_base/commands/led1 kobuki_msgs/Led", "sub /mobile_base/commands/velocity geometry_msgs/Twist"]
  node ros "walker" $ do
    bumps <- subscribe "/mobile_base/events/bumper"
    advertise "/mobile_base/commands/led1" (fmap (\b -> Led (if _state b == 1 then 3 else 0)) bumps)
    odometry <- subscribe "/odom"
    advertise "/mobile_base/commands/velocity" (fmap faster odometry)
    awaitPublishers "/mobile_base/events/bumper" 1
    awaitPublishers "/odom" 1
    liftIO $ do
      mapM_ (say base) ["connected /odom 1", "connected /mobile_base/events/bumper 1", "listening /mobile_base/commands/led1", "listening /mobile_base/commands/velocity"]
      void (hears base "listening /mobile_base/commands/velocity")
      say base "send /mobile_base/events/bumper {\"bumper\": 1, \"state\": 1}"
      void (hears base "got /mobile_base/commands/led1 {\"value\": 3}")
      say base "send /mobile_base/events/bumper {\"bumper\": 1, \"state\": 0}"
      void (hears base "got /mobile_base/commands/led1 {\"value\": 0}")
      say base "send /odom {\"header\": {\"frame_id\": \"odom\"}, \"child_frame_id\": \"base_footprint\", \"twist\": {\"twist\": {\"linear\": {\"x\": 0.25}}}}"
      void (hearsWhere base "half a metre per second more" ("\"x\": 0.75" `isInfixOf`))
  where
    faster :: Odometry -> Twist
    faster o = forward (o ^. Odometry.twist . Covariance.twist . linear . Vector3.x + 0.5)

earlyAndLate :: Ros -> IO ()
earlyAndLate ros = withPeer ros "early" $ \early -> do
  say early "pub /n std_msgs/Int32"
  _ <- hears early "publishing"
  node ros "listener" $ do
    t <- subscribe "/n"
    awaitPublishers "/n" 1
    liftIO $ do
      say early "connected /n 1"
      _ <- hears early "connected"
      say early "send /n {\"data\": 1}"
      T.head t >>= (@?= Int32.Int32 1)
      withPeer ros "late" $ \late -> do
        say late "pub /n std_msgs/Int32"
        say late "connected /n 1"
        _ <- hears late "connected"
        say late "send /n {\"data\": 2}"
        T.take 1 (T.filter (/= Int32.Int32 1) t) >>= (@?= [Int32.Int32 2])

latchedBothWays :: Ros -> IO ()
latchedBothWays ros = withPeer ros "peer" $ \peer -> do
  say peer "pub /theirs std_msgs/String latch"
  say peer "send /theirs {\"data\": \"before you\"}"
  node ros "us" $ do
    ours <- publisherWith publisherOptions {latched = True} "/ours"
    liftIO (publish ours (Ros.String "old") >> publish ours (Ros.String "last"))
    theirs <- subscribe "/theirs"
    liftIO $ do
      T.head theirs >>= (@?= Ros.String "before you")
      say peer "sub /ours std_msgs/String"
      hears peer "got" >>= (@?= "got /ours {\"data\": \"last\"}")

twoThousand :: Ros -> IO ()
twoThousand ros = withPeer ros "peer" $ \peer -> do
  say peer "sub /up std_msgs/Int32 quiet"
  say peer "pub /down std_msgs/Int32"
  -- rospy connects a subscriber before it has its handler, and loses what comes in between.
  _ <- hears peer "publishing /down"
  node ros "us" $ do
    down <- subscribeBuffered 2000 "/down"
    up <- publisherWith publisherOptions {queueSize = 2000} "/up"
    awaitSubscribers up 1
    liftIO $ do
      say peer "connected /down 1"
      say peer "flood /down 2000"
      forM_ [0 .. 1999] (publish up . Int32.Int32)
      got <- T.take 2000 down
      map Int32.__data got @?= [0 .. 1999]
      say peer "heard /up 2000"
      hears peer "heard" >>= (@?= "heard /up True")

-- | Both begin behind the first message, and the second begins when the first has what it wants.
twoReaders :: Ros -> IO ()
twoReaders ros = withPeer ros "peer" $ \peer -> do
  say peer "pub /n std_msgs/Int32"
  node ros "us" $ do
    t <- subscribe "/n"
    liftIO $ do
      mapM_ (say peer) ["connected /n 1", "flood /n 5"]
      (_, both) <- runTopic t
      (,) <$> T.take 2 both <*> T.take 2 both >>= (@?= ([Int32.Int32 1, Int32.Int32 2], [Int32.Int32 1, Int32.Int32 2]))

withRoscpp :: Ros -> IO ()
withRoscpp ros = withProgram ros "/usr/lib/topic_tools/relay" ["/there", "/back"] $ \_ ->
  node ros "us" $ do
    back <- subscribe "/back"
    there <- publisher "/there"
    awaitSubscribers there 1
    -- The relay offers its topic when it has had a message, and may lose those it gets before it has a listener.
    let knock n = publish there (Int32.Int32 n)
    connected <- isConnectedTo "/back"
    liftIO $ do
      knock 0
      atomically (connected >>= check)
      -- Its queues hold ten, so each message is sent when the one before has come round.
      let inStep n t
            | n > 100 = pure ()
            | otherwise = do
              knock n
              came <- timeout 500000 (T.head (T.filter (== Int32.Int32 n) t))
              inStep (maybe n (const (n + 1)) came) t
      inStep 1 back

baseRestart :: Ros -> IO ()
baseRestart ros = node ros "us" $ do
  t <- subscribe "/n"
  liftIO $ do
    withPeer ros "mobile_base" $ \base -> do
      talk base 1 t
      killPeer base -- still registered, at an address where nothing listens
    withPeer ros "mobile_base" $ \base -> talk base 2 t
  where
    talk base n t = do
      say base "pub /n std_msgs/Int32"
      say base "connected /n 1"
      _ <- hears base "connected"
      say base ("send /n {\"data\": " ++ show n ++ "}")
      T.head t >>= (@?= Int32.Int32 n)

-- | The slow one connects by hand and reads nothing until all is published. Each message is published when
-- the fast one has read the one before, so that only the slow one falls behind.
slowSubscriber :: Ros -> IO ()
slowSubscriber ros = node ros "us" $ do
  p <- publisherWith publisherOptions {queueSize = 10} "/big"
  fast <- subscribe "/big"
  core <- askCore
  awaitSubscribers p 1
  liftIO . bracket (topicSocket core "/big") close $ \slow -> do
    sendAll slow (frame (encodeFields (subscriberFields (Offer "/slow" "/big" "std_msgs/String" "*" ""))))
    (_, behindHeader) <- pieces slow noBytes
    outlets <- atomically (readTVar (publications core) >>= mapM (readTVar . pubOutlets))
    map length (Map.elems outlets) @?= [2] -- it has its place before it is answered
    let inStep i t = do
          publish p (Ros.String (show i ++ replicate 10000 ' '))
          (Ros.String text, rest) <- runTopic t
          number text @?= i
          if i < count then inStep (i + 1) rest else pure ()
    inStep 1 fast
    got <- map (number . drop 4 . C.unpack) <$> untilLast slow behindHeader []
    last got @?= count
    assertBool "some were left out" (length got < count)
    assertBool "those that came are in order" (and (zipWith (<) got (drop 1 got)))
  where
    count = 2000 :: Int
    number = read . takeWhile (/= ' ')
    pieces s st = do
      b <- recv s 65536
      (ps, st') <- either (assertFailure . show) pure (feed maxFrame st b)
      if null ps then pieces s st' else pure (ps, st')
    untilLast s st seen = do
      (ps, st') <- pieces s st
      let seen' = seen ++ ps
      if C.pack (show count) `C.isPrefixOf` C.drop 4 (last ps) then pure seen' else untilLast s st' seen'

-- | A connection to the port where a node serves this topic.
topicSocket :: Core -> String -> IO Socket
topicSocket core topic = do
  answer <- call (coreUri core) (Call "requestTopic" [VString "/test", VString topic, VArray [VArray [VString "TCPROS"]]])
  case answer of
    Right (VArray [VInt 1, _, VArray [_, VString host, VInt port]]) -> connectTo host port
    other -> assertFailure (show other)

nameClash :: Ros -> IO ()
nameClash ros = do
  withAsync (node ros "same" (publisher "/x" >>= \p -> awaitEnd <* liftIO (publish p (Int32.Int32 1)))) $ \ours -> do
    awaitNode ros "/same"
    withPeer ros "same" $ \_ -> do
      why <- wait ours
      case why of
        AskedTo reason -> assertBool reason ("same" `isInfixOf` reason)
        _ -> assertFailure "it ended for another reason"
  withPeer ros "same" $ \theirs -> node ros "same" (publisher "/x" >>= \p -> liftIO (publish p (Int32.Int32 1) >> void (hears theirs "shutdown")))

-- | The master still knows one that has not been heard of since; whichever looks first, it or we, that one is no rival.
startedAgain :: Ros -> IO ()
startedAgain ros = withPeer ros "peer" $ \peer -> do
  say peer "sub /x std_msgs/Int32"
  forM_ [1 .. 10] $ \n -> do
    _ <- call (rosMaster ros) (Call "registerPublisher" [VString "/us", VString "/old", VString "std_msgs/Int32", VString "http://127.0.0.1:1/"])
    node ros "us" $ do
      core <- askCore
      p <- publisherWith publisherOptions {latched = True} "/x"
      liftIO $ do
        publish p (Int32.Int32 n)
        _ <- hears peer ("got /x {\"data\": " ++ show n ++ "}")
        ended <- atomically (tryReadTMVar (ending core))
        maybe (pure ()) (const (assertFailure "it took the one before it for a rival")) ended

printsATopic :: Ros -> IO ()
printsATopic ros = withPeer ros "mobile_base" $ \base -> do
  say base "pub /mobile_base/events/bumper kobuki_msgs/BumperEvent latch"
  say base "send /mobile_base/events/bumper {\"bumper\": 1, \"state\": 1}"
  withProgram ros "ros-print-topic" ["bumper:=/mobile_base/events/bumper"] $ \p -> void (hears p "BumperEvent {_bumper = 1, _state = 1}")

-- | It drives at 0.2 m/s, and has 0.5 m more than it wants to keep: half of the change towards 0.25 m/s. Then only 0.1 m.
fuses :: Ros -> IO ()
fuses ros = withPeer ros "mobile_base" $ \base -> do
  mapM_ (say base) ["pub /odom nav_msgs/Odometry", "pub /scan sensor_msgs/LaserScan", "sub /cmd_vel geometry_msgs/Twist"]
  withProgram ros "ros-fuse" ["_top_speed:=0.3"] $ \_ -> do
    mapM_ (say base) ["connected /odom 1", "connected /scan 1", "listening /cmd_vel"]
    _ <- hears base "listening"
    scanned base "0.8"
    void (hears base "got /cmd_vel {\"linear\": {\"x\": 0.22")
    scanned base "0.4"
    void (hears base "got /cmd_vel {\"linear\": {\"x\": 0.12")
  where
    scanned base metres = do
      say base "send /odom {\"twist\": {\"twist\": {\"linear\": {\"x\": 0.2}}}}"
      say base ("send /scan {\"ranges\": [2.0, " ++ metres ++ "]}")

-- | Waits until the master knows this node.
awaitNode :: Ros -> String -> IO ()
awaitNode ros name = do
  known <- call (rosMaster ros) (Call "lookupNode" [VString "/test", VString name])
  case known of
    Right (VArray (VInt 1 : _)) -> pure ()
    _ -> awaitNode ros name

parameters :: Ros -> IO ()
parameters ros = withPeer ros "peer" $ \peer ->
  withNodeIn (settingsFor ros ["_rate:=2.5", "_label:=fast", "_count:=3"]) "us" $ do
    fromArguments <- (,,) <$> getParam "~rate" (0 :: Double) <*> getParam "~label" "" <*> getParam "~count" (0 :: Int)
    liftIO (fromArguments @?= (2.5, "fast", 3))
    setParam "/list" [1, 2, 3 :: Int]
    liftIO $ do
      say peer "param get /list"
      hears peer "param" >>= (@?= "param [1, 2, 3]")
      say peer "param set /speed 0.5"
      void (hears peer "done")
    speeds <- watchParam "/speed"
    liftIO $ do
      (now, later) <- runTopic speeds
      now @?= (0.5 :: Double)
      say peer "param set /speed 2"
      T.head later >>= (@?= 2)
    absent <- getParamOpt "/nothing" :: Node (Maybe String)
    found <- searchParam "speed"
    deleteParam "/speed"
    there <- hasParam "/speed"
    wrong <- nodeIO (\run -> try (run (getParam "/list" (0 :: Double))))
    liftIO ((absent, found, there, wrong) @?= (Nothing, Just "/speed", False, Left (OtherParam "/list" "VArray [VInt 1,VInt 2,VInt 3]")))

remapped :: Ros -> IO ()
remapped ros = withPeer ros "peer" $ \peer -> do
  say peer "sub /elsewhere/talk std_msgs/String"
  withNodeIn (settingsFor ros ["chatter:=talk", "__ns:=elsewhere", "__name:=renamed", "plain"]) "us" $ do
    p <- publisherWith publisherOptions {latched = True} "chatter"
    liftIO (publish p (Ros.String "hi"))
    (,,) <$> getName <*> getNamespace <*> getArguments >>= \names -> liftIO (names @?= ("/elsewhere/renamed", "/elsewhere", ["plain"]))
    liftIO (void (hears peer "got /elsewhere/talk {\"data\": \"hi\"}"))

-- | The master is told this address, a subscriber is sent there, and there it is heard.
ownAddress :: Ros -> IO ()
ownAddress ros = forM_ cases $ \(given, args, expected) -> withPeer ros "peer" $ \peer -> do
  say peer "sub /n std_msgs/Int32"
  withNodeIn (Settings (readArguments args) (given ++ without) "test") "us" $ do
    p <- publisherWith publisherOptions {latched = True} "/n"
    core <- askCore
    liftIO $ do
      publish p (Int32.Int32 1)
      known <- call (rosMaster ros) (Call "lookupNode" [VString "/test", VString "/us"])
      case known of
        Right (VArray [VInt 1, _, VString uri]) -> fmap uriHost (readUri uri) @?= Just expected
        other -> assertFailure (show other)
      answer <- call (coreUri core) (Call "requestTopic" [VString "/test", VString "/n", VArray [VArray [VString "TCPROS"]]])
      case answer of
        Right (VArray [VInt 1, _, VArray [_, VString host, _]]) -> host @?= expected
        other -> assertFailure (show other)
      void (hears peer "got /n {\"data\": 1}")
  where
    without = filter ((`notElem` ["ROS_IP", "ROS_HOSTNAME"]) . fst) (rosEnvironment ros)
    cases =
      [ ([], [], "127.0.0.1"), -- the address by which the master is reached
        ([("ROS_IP", "127.0.0.2")], [], "127.0.0.2"),
        ([("ROS_HOSTNAME", "localhost"), ("ROS_IP", "127.0.0.2")], [], "localhost"),
        ([("ROS_HOSTNAME", ""), ("ROS_IP", "127.0.0.2")], [], "127.0.0.2"),
        ([("ROS_HOSTNAME", "localhost")], ["__ip:=127.0.0.3"], "127.0.0.3"),
        ([("ROS_IP", "127.0.0.2")], ["__hostname:=localhost"], "localhost")
      ]

-- | Needs no master: a node waits for it.
masterStory :: TestTree
masterStory = testCase "it looks for the master where ROS_MASTER_URI or __master says, and refuses what is no address" $ do
  forM_ [([], [], Uri "localhost" 11311), (at "http://127.0.0.1:1/", [], Uri "127.0.0.1" 1), (at "http://127.0.0.1:1", ["__master:=http://127.0.0.1:2"], Uri "127.0.0.1" 2)] $ \(given, args, expected) ->
    withNodeIn (Settings (readArguments args) given "test") "us" (coreMaster <$> askCore) >>= (@?= expected)
  forM_ ["ftp://robot", "http://:11311", "http://robot:99999"] $ \strange ->
    try (withNodeIn (Settings (readArguments []) (at strange) "test") "us" (pure ())) >>= (@?= Left (StrangeMaster strange))
  where
    at uri = [("ROS_MASTER_URI", uri)]

logs :: HasCallStack => Ros -> IO ()
logs ros = withPeer ros "peer" $ \peer -> do
  say peer "rosout"
  node ros "us" $ do
    log' <- enableLogging Nothing
    liftIO $ do
      logTo log' Debug "only for rosout"
      hears peer "log /us" >>= (@?= "log /us 1 logs only for rosout")

otherType :: Ros -> IO ()
otherType ros = node ros "us" $ do
  p <- publisher "/n"
  core <- askCore
  liftIO (publish p (Int32.Int32 1))
  liftIO . bracket (topicSocket core "/n") close $ \s -> do
    sendAll s (frame (encodeFields (subscriberFields (Offer "/wrong" "/n" "std_msgs/String" "992ce8a1687cec8c8bd883ec73ca41d1" ""))))
    answer <- untilClosed s
    assertBool (C.unpack answer) (C.pack "error=the other node has std_msgs/String" `C.isInfixOf` answer)
  where
    untilClosed s = recv s 4096 >>= \b -> if C.null b then pure b else (b <>) <$> untilClosed s

twoTypes :: Ros -> IO ()
twoTypes ros = do
  r <- try . node ros "us" $ do
    a <- publisher "/n"
    liftIO (publish a (Int32.Int32 1))
    b <- publisher "/n"
    liftIO (publish b (Ros.String "one"))
  r @?= Left (TwoTypes "/n" "std_msgs/Int32" "std_msgs/String")

handlerFails :: Ros -> IO ()
handlerFails ros = do
  why <- node ros "us" $ do
    runHandler_ (\() -> throwIO (ErrorCall "no wheel")) (T.repeat ())
    awaitEnd
  case why of
    Failed e -> show e @?= "no wheel"
    _ -> assertFailure "it ended for another reason"

saysGoodbye :: Ros -> IO ()
saysGoodbye ros = withPeer ros "mobile_base" $ \base -> do
  say base "sub /mobile_base/commands/velocity geometry_msgs/Twist"
  _ <- hears base "subscribed"
  node ros "us" $ do
    p <- publisher "/mobile_base/commands/velocity"
    awaitSubscribers p 1
    liftIO (mapM_ (publish p . forward) ([0.1, 0.2 .. 1] ++ [0]))
  _ <- hearsWhere base "a stop" (isInfixOf "\"linear\": {\"x\": 0.0")
  answer <- call (rosMaster ros) (Call "lookupNode" [VString "/test", VString "/us"])
  case answer of
    Right (VArray [VInt (-1), _, _]) -> pure ()
    other -> assertFailure (show other)

-- | A node in a process of its own, until it is asked to end.
aNode :: IO ()
aNode = runNode "signalled" $ do
  p <- publisher "/x"
  _ <- subscribe "/y" :: Node (Topic IO Ros.String)
  liftIO (publish p (Int32.Int32 1))

endsOnSignals :: Ros -> IO ()
endsOnSignals ros = do
  self <- getExecutablePath
  forM_ ["INT", "TERM"] $ \name ->
    withProgram ros self ["--node"] $ \p -> do
      awaitNode ros "/signalled"
      signal p name
      exitOf p >>= (@?= ExitSuccess)
      answer <- call (rosMaster ros) (Call "getSystemState" [VString "/test"])
      case answer of
        Right (VArray [VInt 1, _, VArray [VArray publishers', VArray subscribers', _]]) -> (publishers', subscribers') @?= ([], [])
        other -> assertFailure (show other)

-- | A master that comes back knows nothing; rospy's nodes do not tell it again, ours does: what it publishes, subscribes to and offers, and the
-- parameters that it watches. The peers are new each time, so they learn of it from the master alone.
restartStory :: Ready -> TestTree
restartStory ready = testCaseInfo "it waits for a master, and registers again with one that was restarted" $ do
  (folder, prepared) <- ready
  either skip (const ("" <$ restartable folder act)) prepared
  where
    act :: Ros -> (forall b. IO b -> IO b) -> IO ()
    act ros start = node ros "us" $ do
      p <- publisherWith publisherOptions {latched = True} "/n"
      heard <- subscribe "/m"
      offerService SetBool "/switch" (\(SetBoolRequest on) -> pure (Right (SetBoolResponse on "it is")))
      liftIO (publish p (Int32.Int32 7))
      liftIO (start (meets ros heard 1))
      speeds <- nodeIO $ \run -> start $ do
        speeds <- run (watchParam "/speed")
        snd <$> meets' ros heard 2 speeds 0.5
      liftIO (start (void (meets' ros heard 3 speeds 2)))
    meets ros heard n = withPeer ros "peer" $ \peer -> do
      say peer "sub /n std_msgs/Int32"
      hears peer "got" >>= (@?= "got /n {\"data\": 7}")
      say peer "call /switch std_srvs/SetBool {\"data\":true}"
      hears peer "answer" >>= (@?= "answer {\"success\": true, \"message\": \"it is\"}")
      say peer "pub /m std_msgs/Int32"
      say peer "connected /m 1"
      _ <- hears peer "connected"
      say peer ("send /m {\"data\": " ++ show n ++ "}")
      T.head (T.filter (== Int32.Int32 n) heard) >>= (@?= Int32.Int32 n)
    meets' ros heard n speeds speed = do
      meets ros heard n
      withPeer ros "setter" $ \peer -> do
        say peer ("param set /speed " ++ show speed)
        _ <- hears peer "done"
        (now, later) <- runTopic speeds
        now @?= (speed :: Double)
        pure (now, later)

-- | So is a master that was restarted between two looks, and to which the node then told something new: here the watch of a
-- parameter stays, and what the node told before is forgotten.
forgotten :: Ros -> IO ()
forgotten ros = node ros "us" $ do
  core <- askCore
  p <- publisherWith publisherOptions {latched = True} "/n"
  _ <- watchParam "/speed" :: Node (Topic IO Double)
  liftIO $ do
    publish p (Int32.Int32 7)
    at <- registered core
    unregisterPublisher (master core) "/n" >>= (@?= Right ())
    unregisterService (master core) "/us/get_loggers" at >>= (@?= Right ())
    withPeer ros "peer" $ \peer -> do
      say peer "sub /n std_msgs/Int32"
      hears peer "got" >>= (@?= "got /n {\"data\": 7}")
  where
    registered core =
      lookupService (master core) "/us/get_loggers" >>= \case
        Right (Just at) -> pure at
        _ -> registered core

-- | A rospy node and one of ours, each in a process of its own, answer a bumper with an LED. A third node asks them in turn.
roundTrip :: Ros -> IO ()
roundTrip ros = do
  self <- getExecutablePath
  withPeer ros "theirs" $ \theirs -> do
    say theirs "echo /bumper1 /led1"
    _ <- hears theirs "echoing"
    withProgram ros self ["--echo"] $ \_ -> withPeer ros "pinger" $ \p -> do
      say p "time 1000 /bumper1 /led1 /bumper2 /led2"
      took <- words <$> hearsWhere p "a measurement" (\l -> take 4 l `elem` ["took", "lost"])
      case took of
        [_, median, high, median', high'] -> do
          putStrLn ("\n      round trip, median and 95th percentile in ms: this client " ++ unwords [median', high'] ++ ", rospy " ++ unwords [median, high])
          hFlush stdout
        _ -> assertFailure "a message was lost"

-- | Ours of the two.
anEcho :: IO ()
anEcho = runNode "ours" $ do
  bumps <- subscribe "/bumper2"
  advertise "/led2" (fmap (Led . _state) bumps)
