{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : A node among peers that say what no peer should.
--
-- Each of them is refused or left alone, and the node goes on with all the others.
module Test.Ros.Hostile (strangeCallers, strangeSubscribers, strangePublishers) where

import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM
import Control.Exception (IOException, bracket, try)
import Control.Monad (forM, forM_, void)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Network.Socket (Socket, close)
import Network.Socket.ByteString (recv, sendAll)
import Ros.Net.Rpc
import Ros.Net.Tcpros
import Ros.Net.XmlRpc
import Ros.Node
import Ros.Node.Core (Core (..))
import qualified Ros.Std_msgs.Int32 as Int32
import Ros.Topic (Topic (..))
import qualified Ros.Topic as T
import System.Timeout (timeout)
import Test.Ros.Peer
import Test.Tasty.HUnit

strangeCallers :: Ros -> IO ()
strangeCallers ros = withNodeIn (settingsFor ros []) "us" $ do
  core <- askCore
  liftIO . saying (uriPort (coreUri core)) half $ do
    forM_ garbage $ \bytes -> connection (uriPort (coreUri core)) $ \s -> sends s bytes >> void (answered s)
    answer <- call (coreUri core) (Call "getPid" [VString "/test"])
    case answer of
      Right (VArray (VInt 1 : _)) -> pure ()
      other -> assertFailure (show other)
  where
    -- Connections that never say the rest.
    half = replicate 20 "" ++ ["POST / HTTP/1.1\r\nContent-Le", "POST / HTTP/1.1\r\nContent-Length: 100\r\n\r\n<methodCall>"]
    garbage =
      ["\0\255\254\r\n\r\n", "GET / HTTP/1.1\r\n\r\n", C.replicate 70000 'x', posted "<methodCall><methodName>publisherUpdate</methodName>", posted "\0\1\2", posted ""]
        ++ ["POST / HTTP/1.1\r\nContent-Length: " <> n <> "\r\n\r\n" | n <- ["99999999999", "-5", "many"]]
        -- Deeper than the decoder reads.
        ++ [posted ("<methodCall><methodName>getPid</methodName><params><param>" <> B.concat (replicate 50000 "<value><array><data>")), posted (C.replicate 3000000 '<')]
    posted body = "POST / HTTP/1.1\r\nContent-Length: " <> C.pack (show (B.length body)) <> "\r\n\r\n" <> body

strangeSubscribers :: Ros -> IO ()
strangeSubscribers ros = withNodeIn (settingsFor ros []) "us" $ do
  p <- publisherWith publisherOptions {latched = True} "/n"
  core <- askCore
  liftIO $ do
    publish p (Int32.Int32 7)
    saying (coreTcpPort core) (replicate 20 "" ++ ["\100\0\0\0half"]) $ do
      forM_ garbage $ \bytes -> connection (coreTcpPort core) $ \s -> do
        sends s bytes
        said <- allOf s
        assertBool (show (bytes, said)) (B.null said || "error=" `B.isInfixOf` said)
      withPeer ros "peer" $ \peer -> do
        say peer "sub /n std_msgs/Int32"
        hears peer "got" >>= (@?= "got /n {\"data\": 7}")
  where
    garbage =
      [ "\255\255\255\255",
        "\4\0\0\0\255\255\255\255",
        header [],
        header [("callerid", "/x"), ("topic", "/other"), ("md5sum", "*")],
        header [("callerid", "/x"), ("topic", "/n"), ("type", "std_msgs/Int32"), ("md5sum", "00000000000000000000000000000000")],
        header [("topic", "/n"), ("md5sum", "*")],
        "\9\0\0\0\5\0\0\0nokey",
        "POST / HTTP/1.1\r\n\r\n"
      ]

strangePublishers :: Ros -> IO ()
strangePublishers ros = do
  met <- newTVarIO (0 :: Int)
  withPublishers met (zip [0 ..] sayings) . withNodeIn (settingsFor ros []) "us" $ do
    t <- subscribe "/n" :: Node (Topic IO Int32.Int32)
    liftIO $ do
      -- Each has been listened to before the good one says anything.
      came <- timeout 120000000 (atomically (readTVar met >>= check . (>= length sayings)))
      assertBool "not all were asked" (came == Just ())
      withPeer ros "peer" $ \peer -> do
        say peer "pub /n std_msgs/Int32"
        say peer "connected /n 1"
        _ <- hears peer "connected"
        say peer "send /n {\"data\": 7}"
        T.head t >>= (@?= Int32.Int32 7)
  where
    sayings =
      [ "\255\255\255\255",
        header [("md5sum", "00000000000000000000000000000000"), ("type", "std_msgs/Int32")],
        header [("type", "std_msgs/Int32")],
        header [("error", "no")],
        good <> "\255\255\255\255",
        good <> "\1\0\0\0x",
        good <> "\100\0\0\0half",
        good,
        "",
        "HTTP/1.1 200 OK\r\n\r\n"
      ]
    good = header [("callerid", "/evil"), ("md5sum", "da5909fbe378aeaf85e547e830cc1bb7"), ("type", "std_msgs/Int32")]
    -- Nodes that the master knows as publishers, each of which says this and then nothing more, and keeps the connection.
    withPublishers met all' act = case all' of
      [] -> act
      (n, saying') : rest ->
        server $ \calls callPort -> server $ \topics topicPort -> do
          let uri = Uri "127.0.0.1" callPort
              reply _ = pure (Answer (VArray [VInt 1, VString "", VArray [VString "TCPROS", VString "127.0.0.1", VInt topicPort]]))
              talk s = recv s 4096 >> sendAll s saying' >> atomically (modifyTVar' met (+ 1)) >> void (allOf s)
          withAsync (serveCalls calls reply) $ \_ -> withAsync (accepting topics talk) $ \_ -> do
            r <- call (rosMaster ros) (Call "registerPublisher" [VString ("/evil" ++ show (n :: Int)), VString "/n", VString "std_msgs/Int32", VString (showUri uri)])
            either (assertFailure . explainRpcError) (const (withPublishers met rest act)) r
    server use = bracket (listenAnywhere True) (close . fst) (uncurry use)

header :: Fields -> B.ByteString
header = frame . encodeFields

connection :: Int -> (Socket -> IO a) -> IO a
connection port = bracket (connectTo "127.0.0.1" port) close

-- | Connections that have said this and stay, meanwhile.
saying :: Int -> [B.ByteString] -> IO a -> IO a
saying port all' act = bracket (forM all' (const (connectTo "127.0.0.1" port))) (mapM_ close) $ \sockets ->
  forM_ (zip sockets all') (uncurry sends) >> act

-- | Who does not want to hear all of it may close.
sends :: Socket -> B.ByteString -> IO ()
sends s bytes = void (try (sendAll s bytes) :: IO (Either IOException ()))

-- | The first that it says, or that it closes.
answered :: Socket -> IO B.ByteString
answered s = either (\(_ :: IOException) -> B.empty) id <$> try (recv s 65536)

allOf :: Socket -> IO B.ByteString
allOf s = answered s >>= \b -> if B.null b then pure b else (b <>) <$> allOf s
