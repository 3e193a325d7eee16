-- |
-- Description : The robots that the tests have: strict rosbridge servers, a rospy node, a base on a pseudo-terminal.
module Test.Robots.Rigs
  ( -- * A test with a robot
    Ready,
    withReady,
    story,

    -- * Robots
    Rig (..),
    rosbridge,
    ros2Robot,
    rospy,
    serial,
    plainEnvironment,
  )
where

import Control.Monad (forM_, void)
import Data.Either (fromLeft)
import Data.List (isInfixOf, isPrefixOf)
import Ros.Net.Rpc (Uri (..))
import System.Directory (createDirectoryIfMissing, getTemporaryDirectory, removeDirectoryRecursive)
import System.Environment (getEnvironment)
import System.Posix.Process (getProcessID)
import Test.Ros.Peer
import Test.Tasty
import Test.Tasty.HUnit

-- | A folder for the tests, and ROS, or why there is none.
type Ready = IO (FilePath, Either String FilePath)

withReady :: (Ready -> TestTree) -> TestTree
withReady = withResource acquire (removeDirectoryRecursive . fst)
  where
    acquire = do
      tmp <- getTemporaryDirectory
      pid <- getProcessID
      let folder = tmp ++ "/robots-test-" ++ show pid
      createDirectoryIfMissing True folder
      (,) folder <$> withRos folder

type WithRig = FilePath -> (Rig -> IO ()) -> IO ()

-- | Skips with a word where the robot cannot be had.
story :: Ready -> (Either String FilePath -> Maybe WithRig) -> String -> (Rig -> IO ()) -> TestTree
story ready rig name act = testCaseInfo name $ do
  (folder, ros) <- ready
  case rig ros of
    Nothing -> pure ("skipped: " ++ fromLeft "" ros)
    Just withRig -> "" <$ withRig folder act

-- | A robot and what it says.
data Rig = Rig
  { -- | the way to it, for people
    called :: String,
    -- | its address
    url :: String,
    options :: String,
    robot :: Peer,
    environment :: Ros,
    -- | it stands at its origin and says so 50 times a second
    streaming :: IO (),
    -- | also takes and sends what only some tests need
    prepared :: IO (),
    -- | waits until a program listens, and is listened to
    attached :: IO (),
    -- | the left bumper is pressed
    bumped :: IO (),
    -- | what it says when it moves, stands, backs off, lights LED 1 red
    moves, stands, backs, red :: String -> Bool
  }

rosbridge :: String -> Either String FilePath -> Maybe WithRig
rosbridge version ros = (\_ use -> plainEnvironment >>= \e -> withProgram e "/usr/bin/python3" [peers "rosbridge.py", version] (act e use)) <$ installed ros
  where
    act e use p = do
      port <- drop 5 <$> hears p "port "
      use
        Rig
          { called = "rosbridge, ROS " ++ version,
            url = "ws://127.0.0.1:" ++ port,
            options = "&ros=" ++ version,
            robot = p,
            environment = e,
            streaming = say p ("stream /odom " ++ odometry (stamp version)),
            prepared = pure (),
            -- Its velocities are advertised when it may be driven.
            attached = hears p "subscribed /odom" >> void (hears p ("advertised " ++ prefix' ++ "/commands/velocity")),
            bumped = say p ("send " ++ prefix' ++ "/events/bumper {\"bumper\": 0, \"state\": 1}"),
            moves = velocity "0.2",
            stands = velocity "0.0",
            backs = velocity "-0.1",
            red = (== "got " ++ prefix' ++ "/commands/led1 {\"value\": 3}")
          }
    prefix' = if version == "2" then "" else "/mobile_base"
    velocity x = isPrefixOf ("got " ++ prefix' ++ "/commands/velocity {\"linear\": {\"x\": " ++ x)

-- | A stand-in for a robot of this name, with these further words for its program and options of its address.
ros2Robot :: String -> [String] -> String -> Either String FilePath -> Maybe WithRig
ros2Robot name more extra ros = (\_ use -> plainEnvironment >>= \e -> withProgram e "/usr/bin/python3" ([peers "ros2_robot.py", name] ++ more) (act e use)) <$ installed ros
  where
    act e use p = do
      port <- drop 5 <$> hears p "port "
      use
        Rig
          { called = name,
            url = "ws://127.0.0.1:" ++ port,
            options = "&robot=" ++ name ++ extra,
            robot = p,
            environment = e,
            streaming = say p ("stream /odom " ++ odometry (stamp "2")),
            prepared = pure (),
            attached = hears p "subscribed /odom" >> void (hears p "advertised /cmd_vel"),
            bumped = say p "hazard 1 bump_front_left on",
            moves = velocity "0.2",
            stands = velocity "0.0",
            backs = velocity "-0.1",
            red = isPrefixOf ("got /cmd_lightring {\"leds\": [" ++ light 0 ++ ", " ++ light 0 ++ ", " ++ light 255 ++ ", " ++ light 255 ++ ", " ++ light 255 ++ ", " ++ light 0 ++ "]")
          }
    velocity x l = "got /cmd_vel" `isPrefixOf` l && ("\"linear\": {\"x\": " ++ x) `isInfixOf` l
    light r = "{\"red\": " ++ show (r :: Int) ++ ", \"green\": 0, \"blue\": 0}"

rospy :: Either String FilePath -> Maybe WithRig
rospy ros = (\folder use -> withMaster folder (\e -> withPeer e "mobile_base" (act e use))) <$ installed ros
  where
    act e use p = do
      mapM_ (say p) ["pub /odom nav_msgs/Odometry", "pub /mobile_base/events/bumper kobuki_msgs/BumperEvent latch", "watchdog /mobile_base/commands/velocity", "sub /mobile_base/commands/led1 kobuki_msgs/Led"]
      _ <- hears p "subscribed"
      use
        Rig
          { called = "ROS 1",
            url = "ros://127.0.0.1:" ++ show (uriPort (rosMaster e)),
            options = "",
            robot = p,
            environment = e,
            streaming = say p ("stream /odom " ++ odometry "") >> void (hears p "streaming"),
            prepared = mapM_ (say p) (["pub /mobile_base/events/" ++ topic ++ " kobuki_msgs/" ++ kind ++ "Event" | (topic, kind) <- others] ++ ["sub /mobile_base/commands/led2 kobuki_msgs/Led", "sub /mobile_base/commands/sound kobuki_msgs/Sound", "sub /rosy/say std_msgs/String"]) >> void (hears p "subscribed /rosy/say"),
            attached = do
              forM_ ("/odom" : ["/mobile_base/events/" ++ topic | topic <- "bumper" : map fst others]) $ \t -> say p ("connected " ++ t ++ " 1") >> hears p ("connected " ++ t)
              forM_ ("/rosy/say" : ["/mobile_base/commands/" ++ topic | topic <- ["velocity", "led1", "led2", "sound"]]) $ \t -> say p ("listening " ++ t) >> hears p ("listening " ++ t),
            bumped = say p "send /mobile_base/events/bumper {\"bumper\": 0, \"state\": 1}",
            moves = velocity "0.2",
            stands = velocity "0.0",
            backs = velocity "-0.1",
            red = (== "got /mobile_base/commands/led1 {\"value\": 3}")
          }
    velocity x = isPrefixOf ("got /mobile_base/commands/velocity {\"linear\": {\"x\": " ++ x)
    others = [("cliff", "Cliff"), ("button", "Button"), ("wheel_drop", "WheelDrop"), ("robot_state", "RobotState")]

-- | Needs no ROS.
serial :: Either String FilePath -> Maybe WithRig
serial _ = Just $ \folder use -> do
  e <- plainEnvironment
  let device = folder ++ "/kobuki"
  withProgram e "/usr/bin/python3" [peers "kobuki.py", device] $ \p -> do
    name <- drop 8 <$> hears p "plugged "
    use
      Rig
        { called = "serial",
          url = "serial:" ++ name,
          options = "",
          robot = p,
          environment = e,
          streaming = pure (),
          prepared = say p "hush" >> void (hears p "hushed"),
          attached = hears p "first " >> void (hears p "versions told"), -- an open line forgets what was said before
          bumped = say p "bump 4",
          moves = (== "control 0.200 0.000 200 0"),
          stands = (== "control 0.000 0.000 0 0"),
          backs = isPrefixOf "control -0.1",
          red = (== "led1 1")
        }

-- | The rosbridge server of the tests needs Python's websockets, which come with ROS's set-up.
installed :: Either String FilePath -> Maybe ()
installed = either (const Nothing) (const (Just ()))

plainEnvironment :: IO Ros
plainEnvironment = Ros (Uri "127.0.0.1" 0) <$> getEnvironment

peers :: String -> FilePath
peers = ("rosy-hs/test-robots/peers/" ++)

-- | A header's time as the two write it.
stamp :: String -> String
stamp version
  | version == "2" = "\"stamp\": {\"sec\": 12, \"nanosec\": 500000000}, "
  | otherwise = "\"seq\": 7, \"stamp\": {\"secs\": 12, \"nsecs\": 500000000}, "

odometry :: String -> String
odometry header = "{\"header\": {" ++ header ++ "\"frame_id\": \"odom\"}, \"child_frame_id\": \"base_footprint\", \"pose\": {\"pose\": {\"position\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0}, \"orientation\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0, \"w\": 1.0}}}, \"twist\": {\"twist\": {\"linear\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0}, \"angular\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0}}}}"
