-- |
-- Description : Programs on robots behind rosbridge, on ROS 1 and on a serial line.
--
-- Each way has its robot: a strict rosbridge server, a rospy node, a base at the end of a pseudo-terminal. The same
-- stories are told of all three: however a program ends, the robot is told to stop, or its own watchdog sees the silence.
module Test.Robots.Links (tests) where

import Control.Monad (forM_, void)
import Data.Either (fromLeft)
import Data.List (isInfixOf, isPrefixOf)
import Ros.Net.Rpc (Uri (..))
import System.Directory (createDirectoryIfMissing, getTemporaryDirectory, removeDirectoryRecursive)
import System.Environment (getEnvironment, getExecutablePath)
import System.Exit (ExitCode (..))
import System.Posix.Process (getProcessID)
import Test.Ros.Peer
import Test.Tasty
import Test.Tasty.HUnit

-- | A robot and what it says.
data Rig = Rig
  { -- | its address
    url :: String,
    options :: String,
    robot :: Peer,
    environment :: Ros,
    -- | the left bumper is pressed
    bumped :: IO (),
    -- | what it says when it moves, stands, backs off, lights LED 1 red
    moves, stands, backs, red :: String -> Bool
  }

tests :: TestTree
tests = withResource acquire (removeDirectoryRecursive . fst) $ \ready ->
  localOption (mkTimeout 60000000) . testGroup "links" $
    [ testGroup name (map (told ready rig) stories)
      | (name, rig) <- [("rosbridge on ROS 1", rosbridge "1"), ("rosbridge on ROS 2", rosbridge "2"), ("ROS 1", rospy), ("serial", serial)]
    ]
      ++ [ testGroup "rosbridge alone" [told' ready (rosbridge "1") "garbage is passed over, and a lost server is found again" lostServer],
           testGroup "serial alone" [told' ready serial "noise, cut and corrupted packets are passed over, and a pulled cable is found again" pulledCable]
         ]
  where
    acquire = do
      tmp <- getTemporaryDirectory
      pid <- getProcessID
      let folder = tmp ++ "/robots-test-" ++ show pid
      createDirectoryIfMissing True folder
      prepared <- withRos folder
      pure (folder, prepared)
    told ready rig (name, story) = told' ready rig name story

type Ready = IO (FilePath, Either String FilePath)

type WithRig = FilePath -> (Rig -> IO ()) -> IO ()

told' :: Ready -> (Either String FilePath -> Maybe WithRig) -> String -> (Rig -> IO ()) -> TestTree
told' ready rig name story = testCaseInfo name $ do
  (folder, prepared) <- ready
  case rig prepared of
    Nothing -> pure ("skipped: " ++ fromLeft "" prepared)
    Just withRig -> "" <$ withRig folder story

stories :: [(String, Rig -> IO ())]
stories =
  [ ( "it drives, backs off from a bumper by the safety rules, and stops when the system asks",
      \r ->
        driving r "on" "steady" $ \p -> do
          bumped r
          sees r "backing off" (backs r)
          signal p "TERM"
          sees r "a stop" (stands r)
          exits p 0
    ),
    ("a program lights an LED", \r -> driving r "off" "lights" $ \_ -> bumped r >> sees r "a red light" (red r)),
    ("it stops on Ctrl-C", \r -> driving r "off" "steady" $ \p -> signal p "INT" >> sees r "a stop" (stands r) >> exits p 0),
    ( "it stops, or is seen to be silent, when the program is killed",
      \r ->
        driving r "off" "steady" $ \p -> killPeer p >> sees r "a stop or silence" (standsOrSilent r)
    ),
    ( "it stops when a function fails",
      \r ->
        driving r "off" "fails" $ \p -> bumped r >> hearsWhere p "the reason" ("the bumper broke me" `isInfixOf`) >> sees r "a stop" (stands r) >> exits p 2
    ),
    ( "it stops, or is seen to be silent, when a function hangs, and Ctrl-C still ends the program",
      \r ->
        driving r "off" "hangs" $ \p -> bumped r >> sees r "a stop or silence" (standsOrSilent r) >> signal p "INT" >> exits p 2
    ),
    ("it stops when the program is done", \r -> driving r "off" "done" $ \p -> bumped r >> sees r "a stop" (stands r) >> exits p 0)
  ]
  where
    standsOrSilent r l = stands r l || l == "watchdog"

-- | A program of its own process, from when the robot moves.
driving :: Rig -> String -> String -> (Peer -> IO a) -> IO a
driving r safety name act = do
  self <- getExecutablePath
  withProgram (environment r) "/bin/sh" ["-c", "exec \"$@\" 2>&1", "sh", self, "--drive", url r ++ "?safety=" ++ safety ++ options r, name] $ \p -> do
    sees r "movement" (moves r)
    act p

sees :: Rig -> String -> (String -> Bool) -> IO ()
sees r what = void . hearsWhere (robot r) what

exits :: Peer -> Int -> IO ()
exits p code = exitOf p >>= (@?= if code == 0 then ExitSuccess else ExitFailure code)

rosbridge :: String -> Either String FilePath -> Maybe WithRig
rosbridge version prepared = (\folder use -> plainEnvironment folder >>= \ros -> withProgram ros "/usr/bin/python3" [peers "rosbridge.py", version] (act ros use)) <$ installed prepared
  where
    act ros use p = do
      port <- drop 5 <$> hears p "port "
      say p ("stream /odom " ++ odometry)
      use
        Rig
          { url = "ws://127.0.0.1:" ++ port,
            options = "&ros=" ++ version,
            robot = p,
            environment = ros,
            bumped = say p ("send " ++ prefix' ++ "/events/bumper {\"bumper\": 0, \"state\": 1}"),
            moves = velocity "0.2",
            stands = velocity "0.0",
            backs = velocity "-0.1",
            red = (== "got " ++ prefix' ++ "/commands/led1 {\"value\": 3}")
          }
    prefix' = if version == "2" then "" else "/mobile_base"
    velocity x = isPrefixOf ("got " ++ prefix' ++ "/commands/velocity {\"linear\": {\"x\": " ++ x)

rospy :: Either String FilePath -> Maybe WithRig
rospy prepared = (\folder use -> withMaster folder (\ros -> withPeer ros "mobile_base" (act ros use))) <$ installed prepared
  where
    act ros use p = do
      mapM_ (say p) ["pub /odom nav_msgs/Odometry", "pub /mobile_base/events/bumper kobuki_msgs/BumperEvent latch", "watchdog /mobile_base/commands/velocity", "sub /mobile_base/commands/led1 kobuki_msgs/Led", "stream /odom " ++ odometry]
      _ <- hears p "streaming"
      use
        Rig
          { url = "ros://127.0.0.1:" ++ show (uriPort (rosMaster ros)),
            options = "",
            robot = p,
            environment = ros,
            bumped = say p "send /mobile_base/events/bumper {\"bumper\": 0, \"state\": 1}",
            moves = velocity "0.2",
            stands = velocity "0.0",
            backs = velocity "-0.1",
            red = (== "got /mobile_base/commands/led1 {\"value\": 3}")
          }
    velocity x = isPrefixOf ("got /mobile_base/commands/velocity {\"linear\": {\"x\": " ++ x)

-- | Needs no ROS.
serial :: Either String FilePath -> Maybe WithRig
serial _ = Just $ \folder use -> do
  ros <- plainEnvironment folder
  self <- show <$> getProcessID
  let device = folder ++ "/kobuki" ++ self
  withProgram ros "/usr/bin/python3" [peers "kobuki.py", device] $ \p -> do
    _ <- hears p "plugged"
    use
      Rig
        { url = "serial:" ++ device,
          options = "",
          robot = p,
          environment = ros,
          bumped = say p "bump 4",
          moves = (== "control 0.200 0.000 200 0"),
          stands = (== "control 0.000 0.000 0 0"),
          backs = isPrefixOf "control -0.1",
          red = (== "led1 1")
        }

-- | The rosbridge server of the tests needs Python's websockets, which come with ROS's set-up.
installed :: Either String FilePath -> Maybe ()
installed = either (const Nothing) (const (Just ()))

plainEnvironment :: FilePath -> IO Ros
plainEnvironment _ = Ros (Uri "127.0.0.1" 0) <$> getEnvironment

peers :: String -> FilePath
peers = ("rosy-hs/test-robots/peers/" ++)

-- | A robot that stands at its origin.
odometry :: String
odometry = "{\"header\": {\"frame_id\": \"odom\"}, \"child_frame_id\": \"base_footprint\", \"pose\": {\"pose\": {\"position\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0}, \"orientation\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0, \"w\": 1.0}}}, \"twist\": {\"twist\": {\"linear\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0}, \"angular\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0}}}}"

lostServer :: Rig -> IO ()
lostServer r = driving r "off" "steady" $ \p -> do
  forM_ ["raw not json", "raw {\"op\":\"status\",\"level\":\"error\",\"msg\":\"x\"}", "raw {\"op\":\"publish\",\"topic\":\"/mobile_base/events/bumper\",\"msg\":{\"bumper\":9,\"state\":null}}", "raw [1]"] (say (robot r))
  say (robot r) "refuse"
  say (robot r) "drop"
  _ <- hearsWhere p "that it is lost" ("is lost" `isInfixOf`)
  say (robot r) "accept"
  _ <- hearsWhere p "that it is back" ("is back" `isInfixOf`)
  sees r "movement again" (moves r)

pulledCable :: Rig -> IO ()
pulledCable r = driving r "off" "steady" $ \p -> do
  forM_ ["noise", "cut", "corrupt", "noise"] (say (robot r))
  say (robot r) "unplug"
  _ <- hearsWhere p "that it is lost" ("is lost" `isInfixOf`)
  say (robot r) "bump 0"
  say (robot r) "plug"
  _ <- hearsWhere p "that it is back" ("is back" `isInfixOf`)
  signal p "TERM"
  sees r "a stop" (stands r)
  exits p 0
