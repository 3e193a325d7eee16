{-# LANGUAGE DataKinds #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : Addresses of robots.
module Test.Robots.Target (tests) where

import Data.Aeson (object, (.=))
import qualified Data.ByteString as B
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import Data.Text.Encoding (encodeUtf16BE, encodeUtf16LE, encodeUtf8)
import qualified Ros.Message as Ros
import Rosy.Codec
import Rosy.Robot
import Rosy.Robots.DynamicMessage
import Rosy.Robots.Guard (Limits (..), Wheels (..))
import Rosy.Robots.RosbridgeCodec (decodeFrame, encodeCommand, frameMessages, velocityRoute)
import Rosy.Robots.Target
import Rosy.Sentence (tr, verbatim)
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "addresses"
    [ testCase "the three ways, with and without ports" $ do
        fmap targetTransport (readTarget "ws://pi:9091/bridge") @?= Right (Rosbridge "pi" 9091 "/bridge")
        fmap targetTransport (readTarget "ws://pi") @?= Right (Rosbridge "pi" 9090 "/")
        fmap targetTransport (readTarget "ros://10.0.0.7") @?= Right (Ros1 "10.0.0.7" 11311)
        fmap targetTransport (readTarget "serial:/dev/kobuki?safety=off") @?= Right (Serial "/dev/kobuki"),
      testCase "an address of ROS 2 has a domain, a computer and a namespace, or none of them" $ do
        [fmap targetTransport (readTarget a) | a <- ["ros2:", "ros2:7", "ros2:@pi", "ros2:7@10.0.0.7/kitchen/base", "ros2:/kitchen", "ros2:0?bridge=9091"]]
          @?= map Right [Ros2 "" "" Nothing, Ros2 "7" "" Nothing, Ros2 "@pi" "" Nothing, Ros2 "7@10.0.0.7" "/kitchen/base" Nothing, Ros2 "" "/kitchen" Nothing, Ros2 "0" "" (Just 9091)]
        [readTarget a | a <- ["ros2:233", "ros2:x", "ros2:7@", "ros2:/", "ros2"]] @?= map (Left . StrangeTarget) ["ros2:233", "ros2:x", "ros2:7@", "ros2:/", "ros2"]
        topics "ros2:7/kitchen" @?= topics "ws://h?ros=2&prefix=/kitchen"
        topics "ros2:7/kitchen?robot=turtlebot3" @?= topics "ws://h?robot=turtlebot3&prefix=/kitchen"
        readTarget "ws://h?bridge=9091" @?= Left (StrangeOption "bridge"),
      testCase "without options a robot is a TurtleBot 2 at a Kobuki's limits, with the safety rules" $ do
        fmap (\t -> (targetLimits t, targetSafety t, targetPatience t)) (readTarget "ros://h") @?= Right (Limits 0.7 pi (Just (Wheels 0.7 0.23)), True, 10)
        topics "ros://h" @?= Right (Just ("/odom", "nav_msgs/Odometry"), Just ("/mobile_base/commands/velocity", "geometry_msgs/Twist"), Just ("/mobile_base/commands/led1", "kobuki_msgs/Led")),
      testCase "ros=2 changes names, and a prefix moves the topics that follow it" $ do
        topics "ws://h?ros=2&prefix=/kitchen" @?= Right (Just ("/kitchen/odom", "nav_msgs/msg/Odometry"), Just ("/kitchen/commands/velocity", "geometry_msgs/msg/Twist"), Just ("/kitchen/commands/led1", "kobuki_ros_interfaces/msg/Led"))
        topics "ros://h?prefix=/b" @?= Right (Just ("/odom", "nav_msgs/Odometry"), Just ("/b/commands/velocity", "geometry_msgs/Twist"), Just ("/b/commands/led1", "kobuki_msgs/Led"))
        fmap velocity (topics "ros://h?velocity=/cmd_vel_mux/input/navi&prefix=/b") @?= Right (Just "/cmd_vel_mux/input/navi")
        fmap velocity (topics "ws://h?ros=2&velocity=/cmd_vel&prefix=/kitchen") @?= Right (Just "/cmd_vel")
        fmap (odometryTopic . targetRoutes) (withFile (Just "{\"ros\": 2, \"odometry\": \"/o\", \"prefix\": \"/a\"}") "ws://h?prefix=/b&profile=x") @?= Right "/o",
      testCase "a profile's options come first, those of the address win" $
        fmap (\t -> (targetLimits t, targetProfile t)) (withFile (Just "{\"max_speed\": 0.3, \"max_turn\": 1, \"ros\": \"2\"}") "ws://h?profile=x.json&max_speed=.2")
          @?= fmap ((,) (Limits 0.2 1 (Just (Wheels 0.7 0.23))) . targetProfile) (readTarget "ws://h?ros=2"),
      testGroup
        "a profile may begin with a byte order mark"
        [ testCase name (fmap targetPatience (withFile (Just (encode "{\"patience\": 5}")) "ws://h?profile=x.json") @?= Right 5)
          | (name, encode) <- [("UTF-8", ("\xEF\xBB\xBF" <>) . encodeUtf8), ("UTF-16, little-endian", ("\xFF\xFE" <>) . encodeUtf16LE), ("UTF-16, big-endian", ("\xFE\xFF" <>) . encodeUtf16BE)]
        ],
      testCase "a profile's numbers may be numbers" $
        fmap (\t -> (targetProfile t, targetPatience t)) (withFile (Just "{\"ros\": 2, \"patience\": 5}") "ws://h?profile=x.json") @?= fmap (\t -> (targetProfile t, 5)) (readTarget "ws://h?ros=2"),
      testCase "robot=turtlesim has the topics, the types and the limits of a turtle" $ do
        fmap (\t -> (named t odometryChannel, named t velocityChannel, named t led1Channel)) (readTarget "ros://h?robot=turtlesim")
          @?= Right (Just ("/turtle1/pose", "turtlesim/Pose"), Just ("/turtle1/cmd_vel", "geometry_msgs/Twist"), Nothing)
        fmap targetLimits (readTarget "ws://h?robot=turtlesim") @?= Right (Limits 2 2 Nothing)
        fmap (`named` odometryChannel) (readTarget "ws://h?robot=turtlesim&ros=2&prefix=/turtle2") @?= Right (Just ("/turtle2/pose", "turtlesim/msg/Pose")),
      testCase "a turtle's pose is odometry, in the frames of a rosbridge server and in ROS 1's bytes" $ do
        let known = either (const []) targetRoutes (readTarget "ros://h?robot=turtlesim")
            turned = OdometryMessage (Odometry (Position 5.5 1) (Orientation 0.5) (Velocity 2 (-1)))
        frameMessages (decodeFrame known [] "{\"op\":\"publish\",\"topic\":\"/turtle1/pose\",\"msg\":{\"x\":5.5,\"y\":1,\"theta\":0.5,\"linear_velocity\":2,\"angular_velocity\":-1}}") @?= [turned]
        -- Five numbers of four bytes; the sum is the one that turtlesim announces.
        let pose = DynamicMessage (object ["x" .= (5.5 :: Double), "y" .= (1 :: Int), "theta" .= (0.5 :: Double), "linear_velocity" .= (2 :: Int), "angular_velocity" .= (-1 :: Int)]) :: DynamicMessage "turtlesim/Pose"
            bytes = Ros.encode pose
        (B.length bytes, Ros.messageMd5 (Proxy :: Proxy (DynamicMessage "turtlesim/Pose"))) @?= (20, "863b248d5016ca62ea2e895ae5265cf9")
        fmap (\(DynamicMessage v) -> readMessages known "/turtle1/pose" v) (Ros.decode bytes :: Either Ros.DecodeError (DynamicMessage "turtlesim/Pose")) @?= Right (Right [turned]),
      testCase "a Create 3 and a TurtleBot 3 are behind rosbridge on ROS 2" $ do
        fmap (\t -> (named t odometryChannel, named t velocityChannel, named t bumperChannel)) (readTarget "ws://h?robot=create3")
          @?= Right (Just ("/odom", "nav_msgs/msg/Odometry"), Just ("/cmd_vel", "geometry_msgs/msg/Twist"), Just ("/hazard_detection", "irobot_create_msgs/msg/HazardDetectionVector"))
        fmap (\t -> (targetLimits t, named t bumperChannel, named t soundChannel)) (readTarget "ws://h?robot=turtlebot3&prefix=/a") @?= Right (Limits 0.22 1.82 Nothing, Nothing, Just ("/a/sound", "turtlebot3_msgs/srv/Sound"))
        fmap (`named` velocityChannel) (readTarget "ws://h?robot=turtlebot3&stamped=on") @?= Right (Just ("/cmd_vel", "geometry_msgs/msg/TwistStamped"))
        readTarget "ros://h?robot=create3" @?= Left (NoSuchWay "create3" (verbatim "ROS 1"))
        readTarget "serial:/dev/kobuki?robot=turtlebot3" @?= Left (NoSuchWay "turtlebot3" (tr "a serial cable"))
        readTarget "ws://h?robot=create3&ros=1" @?= Left (StrangeValue "ros" "1")
        fmap (`named` velocityChannel) (readTarget "ws://h?ros=2&stamped=on") @?= Right (Just ("/commands/velocity", "geometry_msgs/msg/TwistStamped"))
        readTarget "serial:/dev/kobuki?stamped=on" @?= Left (StrangeValue "stamped" "on"),
      testGroup
        "velocities go where the robot's server says that they are taken, as the type that it names"
        [ testCase name (fmap (fmap (\r -> (routeTopic r, routeType r))) (velocityRoute (Map.fromList answers) turtlebot) @?= expected)
          | (name, answers, expected) <-
              [ ("a Twist", [("/cmd_vel", Just "geometry_msgs/msg/Twist"), ("/cmd_vel_stamped", Just "")], Right (Just ("/cmd_vel", "geometry_msgs/msg/Twist"))),
                ("a TwistStamped", [("/cmd_vel", Just "geometry_msgs/msg/TwistStamped"), ("/cmd_vel_stamped", Just "")], Right (Just ("/cmd_vel", "geometry_msgs/msg/TwistStamped"))),
                ("a Create 3 with firmware I.0.0", [("/cmd_vel", Just ""), ("/cmd_vel_stamped", Just "geometry_msgs/msg/TwistStamped")], Right (Just ("/cmd_vel_stamped", "geometry_msgs/msg/TwistStamped"))),
                ("both: the plain one", [("/cmd_vel", Just "geometry_msgs/msg/Twist"), ("/cmd_vel_stamped", Just "geometry_msgs/msg/TwistStamped")], Right (Just ("/cmd_vel", "geometry_msgs/msg/Twist"))),
                ("no node has it", [("/cmd_vel", Just ""), ("/cmd_vel_stamped", Just "")], Right Nothing),
                ("the server cannot say", [("/cmd_vel", Nothing), ("/cmd_vel_stamped", Nothing)], Right Nothing),
                ("a type that Rosy does not send", [("/cmd_vel", Just "ackermann_msgs/msg/AckermannDrive")], Left "ackermann_msgs/msg/AckermannDrive")
              ]
        ],
      testGroup
        "a velocity with a time has the robot's time and the frame of its base"
        [ testCase address $
            fst (encodeCommand (either (const []) targetRoutes (readTarget address)) 12.25 (VelocityCommand (Velocity 0.5 0)) nothingHeld)
              @?= Just ("{\"op\":\"publish\",\"topic\":\"/cmd_vel\",\"msg\":{\"header\":{\"stamp\":{" <> stamp <> "},\"frame_id\":\"base_link\"},\"twist\":{\"linear\":{\"x\":0.5,\"y\":0.0,\"z\":0.0},\"angular\":{\"z\":0.0,\"x\":0.0,\"y\":0.0}}}}")
          | (address, stamp) <- [("ws://h?robot=turtlebot3&stamped=on", "\"sec\":12,\"nanosec\":250000000"), ("ros://h?velocity=/cmd_vel&stamped=on", "\"secs\":12,\"nsecs\":250000000")]
        ],
      testCase "a Create 3's hazards are events when they come and when they are absent" $ do
        let known = either (const []) targetRoutes (readTarget "ws://h?robot=create3")
            vector entries = "{\"op\":\"publish\",\"topic\":\"/hazard_detection\",\"msg\":{\"header\":{},\"detections\":[" <> entries <> "]}}"
            play levels (frame : rest) = let (ms, levels') = onlyChanges known (frameMessages (decodeFrame known [] frame)) levels in ms : play levels' rest
            play _ [] = []
            bump = "{\"header\":{\"frame_id\":\"bump_front_left\"},\"type\":1}"
            strange = "{\"header\":{\"frame_id\":\"base_link\"},\"type\":1}"
            stall = "{\"header\":{\"frame_id\":\"left_wheel\"},\"type\":3}"
            fall = "{\"header\":{\"frame_id\":\"right_wheel\"},\"type\":4}"
            backup = "{\"header\":{\"frame_id\":\"base_link\"},\"type\":0}"
        play noLevels [vector "", vector bump, vector (bump <> "," <> stall), vector (strange <> "," <> backup), vector fall, vector ""]
          @?= [ [],
                [BumperMessage (Bumper LeftBumper Pressed)],
                [],
                [BumperMessage (Bumper LeftBumper Released), BumperMessage (Bumper CenterBumper Pressed)],
                [BumperMessage (Bumper CenterBumper Released), WheelMessage (Wheel RightWheel Air)],
                [WheelMessage (Wheel RightWheel Ground)]
              ],
      testCase "both lights of a Create 3 are in each message, and its motors and a TurtleBot 3's sounds are services" $ do
        let told address = go nothingHeld
              where
                known = either (const []) targetRoutes (readTarget address)
                go held (a : rest) = let (frame, held') = encodeCommand known 0 a held in frame : go held' rest
                go _ [] = []
            ring l r = "{\"op\":\"publish\",\"topic\":\"/cmd_lightring\",\"msg\":{\"leds\":[" <> r <> "," <> r <> "," <> l <> "," <> l <> "," <> l <> "," <> r <> "],\"override_system\":true}}"
            dark = "{\"red\": 0, \"green\": 0, \"blue\": 0}"
            red' = "{\"red\": 255, \"green\": 0, \"blue\": 0}"
            green = "{\"red\": 0, \"green\": 255, \"blue\": 0}"
        told "ws://h?robot=create3" [Led1Command (Led1 Red), Led2Command (Led2 Green), MotorPowerCommand MotorsOff]
          @?= [Just (ring red' dark), Just (ring red' green), Just "{\"op\":\"call_service\",\"service\":\"/e_stop\",\"type\":\"irobot_create_msgs/srv/EStop\",\"args\":{\"e_stop_on\":true}}"]
        told "ws://h?robot=turtlebot3" [SoundCommand ErrorSound, Led1Command (Led1 Red)]
          @?= [Just "{\"op\":\"call_service\",\"service\":\"/sound\",\"type\":\"turtlebot3_msgs/srv/Sound\",\"args\":{\"value\":3}}", Nothing],
      testCase "what cannot be read is said" $ do
        readTarget "http://h" @?= Left (StrangeTarget "http://h")
        readTarget "ws://h:99999" @?= Left (StrangeTarget "ws://h:99999")
        readTarget "ws://h?colour=red" @?= Left (StrangeOption "colour")
        readTarget "ws://h?max_speed=-1" @?= Left (StrangeValue "max_speed" "-1")
        readTarget "ws://h?safety=maybe" @?= Left (StrangeValue "safety" "maybe")
        withFile (Just "[]") "ws://h?profile=x" @?= Left (StrangeProfile "x")
        readTarget "ws://h?robot=hoover" @?= Left (UnknownRobot "hoover")
    ]
  where
    -- Topic and type of odometry, of velocity and of the first light.
    topics address = fmap (\t -> (named t odometryChannel, named t velocityChannel, named t led1Channel)) (readTarget address)
    named t c = fmap (\r -> (routeTopic r, routeType r)) (routeFor (targetRoutes t) c)
    velocity (_, v, _) = fmap fst v
    turtlebot = head [r | Right t <- [readTarget "ws://h?robot=turtlebot3"], r <- targetRoutes t, routeChannel r == velocityChannel]
