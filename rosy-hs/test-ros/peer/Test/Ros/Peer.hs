-- |
-- Description : A real ROS around a test: a master on a port of its own, rospy nodes, ROS's tools.
--
-- In: what to start and what to say to it. Out: what it says. Everything started here ends with the
-- action that it was started for. Nothing sleeps: a test waits for words.
module Test.Ros.Peer
  ( Ros (..),
    withRos,
    withMaster,
    restartable,
    settingsFor,
    Peer,
    withPeer,
    withProgram,
    say,
    hears,
    hearsWhere,
    transcript,
    awaitTranscript,
    killPeer,
    signal,
    signalChildren,
    exitOf,
    tool,
  )
where

import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM
import Control.Exception
import Control.Monad (void)
import Data.List (isInfixOf)
import Network.Socket
import Ros.Names (readArguments)
import Ros.Net.Rpc (Uri (..), call)
import Ros.Net.XmlRpc (Call (..), Value (..))
import Ros.Node (Settings (..))
import System.Environment (getEnvironment)
import System.Exit (ExitCode (..))
import System.IO
import System.Process
import System.Timeout (timeout)
import Test.Tasty.HUnit (assertFailure)

-- | Where a master is and what programs need in their environment to find it.
data Ros = Ros {rosMaster :: Uri, rosEnvironment :: [(String, String)]}

-- | Prepares ROS once; gives the folder of Python modules, or why there is none.
withRos :: FilePath -> IO (Either String FilePath)
withRos folder = do
  (code, out, err) <- readProcessWithExitCode "rosy-hs/test-ros/setup-ros" [folder] ""
  pure $ case code of
    ExitSuccess -> Right folder
    _ -> Left (unwords (lines (out ++ err)))

-- | A master while the action runs.
withMaster :: FilePath -> (Ros -> IO a) -> IO a
withMaster folder act = restartable folder (\ros start -> start (act ros))

-- | The second argument runs a master, always on the same port.
restartable :: FilePath -> (Ros -> (forall b. IO b -> IO b) -> IO a) -> IO a
restartable folder act = withFreePort $ \port -> do
  inherited <- getEnvironment
  let uri = Uri "127.0.0.1" port
      ours = [("ROS_MASTER_URI", "http://127.0.0.1:" ++ show port), ("ROS_IP", "127.0.0.1"), ("ROS_HOME", folder ++ "/home"), ("PYTHONPATH", folder), ("PYTHONUNBUFFERED", "1")]
      env' = ours ++ filter ((`notElem` map fst ours) . fst) inherited
      start :: IO b -> IO b
      start inner = running env' "/usr/bin/rosmaster" ["--core", "-p", show port, "-w", "3"] (\_ -> awaitMaster uri >> inner)
  act (Ros uri env') start

-- | A port of this process alone. It is bound here and not listened to: the system gives it to no other process, and a master,
-- which wants its address reused, may listen there.
withFreePort :: (Int -> IO a) -> IO a
withFreePort use = bracket (socket AF_INET Stream defaultProtocol) close $ \s -> do
  setSocketOption s ReuseAddr 1
  bind s (SockAddrInet 0 (tupleToHostAddress (127, 0, 0, 1)))
  socketPort s >>= use . fromIntegral

awaitMaster :: Uri -> IO ()
awaitMaster uri = do
  there <- call uri (Call "getPid" [VString "/test"])
  either (const (awaitMaster uri)) (const (pure ())) there

settingsFor :: Ros -> [String] -> Settings
settingsFor ros args = Settings (readArguments args) (rosEnvironment ros) "test"

data Peer = Peer {peerIn :: Handle, peerLines :: TVar [String], peerAll :: TVar [String], peerProcess :: ProcessHandle}

running :: [(String, String)] -> FilePath -> [String] -> (ProcessHandle -> IO a) -> IO a
running env' program args use =
  bracket
    (withNull (\null' -> createProcess (proc program args) {env = Just env', std_out = UseHandle null', std_err = UseHandle null'}))
    (\(_, _, _, p) -> stop p)
    (\(_, _, _, p) -> use p)
  where
    withNull use' = openFile "/dev/null" WriteMode >>= use'

stop :: ProcessHandle -> IO ()
stop p = terminateProcess p >> timeout 2000000 (waitForProcess p) >>= maybe (killHard p) (const (pure ()))

killHard :: ProcessHandle -> IO ()
killHard p = getPid p >>= mapM_ (sendSignal "KILL" . show) >> void (waitForProcess p)

-- | A rospy node of this name, ready to be told what to do.
withPeer :: Ros -> String -> (Peer -> IO a) -> IO a
withPeer ros name use = withProgram ros "/usr/bin/python3" ["rosy-hs/test-ros/peers/peer.py", name] (\p -> hears p "ready" >> use p)

withProgram :: Ros -> FilePath -> [String] -> (Peer -> IO a) -> IO a
withProgram ros program args use =
  bracket
    (createProcess (proc program args) {env = Just (rosEnvironment ros), std_in = CreatePipe, std_out = CreatePipe})
    (\(_, _, _, p) -> stop p)
    ( \(i, o, _, p) -> case (i, o) of
        (Just hin, Just hout) -> do
          hSetBuffering hin LineBuffering
          said <- newTVarIO []
          ever <- newTVarIO []
          withAsync (collect hout said ever) (\_ -> use (Peer hin said ever p))
        _ -> assertFailure "no pipes"
    )
  where
    collect h said ever = (hGetLine h >>= \l -> atomically (modifyTVar' said (++ [l]) >> modifyTVar' ever (l :)) >> collect h said ever) `catch` \(_ :: IOException) -> pure ()

say :: Peer -> String -> IO ()
say p = hPutStrLn (peerIn p)

-- | Waits for a line that begins so, and forgets it and what came before.
hears :: Peer -> String -> IO String
hears p start = hearsWhere p ("a line with " ++ show start) (\l -> take (length start) l == start)

-- | Waits for such a line. When none comes, the failure has the newest lines: a robot that streams says thousands.
hearsWhere :: Peer -> String -> (String -> Bool) -> IO String
hearsWhere p what wanted = do
  found <- timeout 120000000 . atomically $ do
    ls <- readTVar (peerLines p)
    case dropWhile (not . wanted) ls of
      [] -> retry
      l : rest -> writeTVar (peerLines p) rest >> pure l
  maybe (readTVarIO (peerLines p) >>= \ls -> assertFailure ("waited for " ++ what ++ "; heard only " ++ show (drop (length ls - 50) ls))) pure found

-- | All that it has ever said.
transcript :: Peer -> IO [String]
transcript p = reverse <$> readTVarIO (peerAll p)

-- | Waits until all that it has said is so; an assertion about what it said tells what is wrong better than a time limit.
awaitTranscript :: Peer -> ([String] -> Bool) -> IO ()
awaitTranscript p wanted = void . timeout 120000000 . atomically $ readTVar (peerAll p) >>= check . wanted . reverse

-- | Like pulling its plug.
killPeer :: Peer -> IO ()
killPeer = killHard . peerProcess

-- | A signal by its name.
signal :: Peer -> String -> IO ()
signal p name = getPid (peerProcess p) >>= mapM_ (sendSignal name . show)

-- | The same for the processes that it has started.
signalChildren :: Peer -> String -> IO ()
signalChildren p name = getPid (peerProcess p) >>= mapM_ (\n -> sendSignal name ("$(cat /proc/" ++ show n ++ "/task/*/children)"))

-- | A signal to the processes with these numbers, by the shell: a bare Ubuntu has no program @kill@.
sendSignal :: String -> String -> IO ()
sendSignal name processes = callProcess "sh" ["-c", "kill -" ++ name ++ " " ++ processes]

-- | How it ends.
exitOf :: Peer -> IO ExitCode
exitOf = waitForProcess . peerProcess

-- | Runs one of ROS's tools until what it prints contains these words.
tool :: Ros -> String -> [String] -> [String] -> IO ()
tool ros program args wanted = do
  (_, out, err) <- readCreateProcessWithExitCode (proc ("/usr/bin/" ++ program) args) {env = Just (rosEnvironment ros)} ""
  let text = out ++ err
  mapM_ (\w -> if w `isInfixOf` text then pure () else assertFailure (unwords (program : args) ++ " does not say " ++ show w ++ " but:\n" ++ text)) wanted
