{-# LANGUAGE PatternSynonyms #-}

-- |
-- Description : Programs on robots behind rosbridge, on ROS 1 and on a serial line.
--
-- Each way has its robot: a strict rosbridge server, a rospy node, a base at the end of a pseudo-terminal. The same
-- stories are told of all three: however a program ends, the robot is told to stop, or its own watchdog sees the silence.
module Test.Robots.Links (tests) where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM (atomically)
import Control.Monad (forM_, forever, unless, void)
import Data.IORef
import Data.List (isInfixOf, isPrefixOf, nub, transpose)
import Rosy.Robot (Led1 (..), LedColor (..), Velocity (..), pattern Led1Command, pattern VelocityCommand)
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.Connection
import Rosy.Robots.Guard (longestAbsence)
import System.Environment (getExecutablePath)
import System.Exit (ExitCode (..))
import System.IO (hFlush, stdout)
import Test.Robots.Rigs
import Test.Robots.Same (reached)
import Test.Ros.Peer
import Test.Tasty
import Test.Tasty.HUnit

tests :: Ready -> TestTree
tests ready = localOption (mkTimeout 300000000) . withResource (newIORef []) printed $ \times ->
  testGroup "links" $
    [ testGroup name [story ready rig title (act times) | (title, act) <- stories]
      | (name, rig) <- [("rosbridge on ROS 1", rosbridge "1"), ("rosbridge on ROS 2", rosbridge "2"), ("a Create 3", ros2Robot "create3" [] ""), ("ROS 1", rospy), ("serial", serial)]
    ]
      ++ [ testGroup
             "what is waited for is said"
             [ waiting "ws://127.0.0.1:1" "nothing listens there",
               waiting "ws://nowhere.invalid" "no computer here has this name",
               waiting "ros://127.0.0.1:1" "no ROS master answers",
               waiting "serial:/dev/no-such-kobuki" "it is not plugged in"
             ],
           testGroup
             "a cable is pulled between two computers"
             [story ready rig name (cutOff times) | (name, rig) <- [("rosbridge on ROS 1", rosbridge "1"), ("rosbridge on ROS 2", rosbridge "2"), ("ROS 1", rospy)]],
           testGroup
             "a program that was frozen does not drive on by itself"
             [ story ready rig name (standsUntilArmed "stood" frozen)
               | (name, rig) <- [("rosbridge on ROS 1", rosbridge "1"), ("rosbridge on ROS 2", rosbridge "2"), ("ROS 1", rospy), ("serial", serial)]
             ],
           testGroup
             "a movement that was decided before a freeze is a stop after it"
             [ story ready rig name decidedBefore
               | (name, rig) <- [("rosbridge on ROS 1", rosbridge "1"), ("rosbridge on ROS 2", rosbridge "2"), ("ROS 1", rospy), ("serial", serial)]
             ],
           testGroup
             "the velocity topic's type is asked"
             [ story ready (ros2Robot name words' "") (unwords (name : words')) stampedDrive
               | (name, words') <- [("turtlebot3", []), ("turtlebot3", ["stamped"]), ("create3", ["stamped"]), ("create3", ["iron"])]
             ],
           testGroup
             "a robot that appears after the connection, whose publishers are best effort"
             [ story ready (ros2Robot name ("late" : words') "") (unwords (name : words')) lateRobot
               | (name, words') <- [("turtlebot3", ["stamped"]), ("create3", [])]
             ],
           testGroup
             "a robot that is told to drive and stands: likely causes are said"
             [ story ready (rosbridge "2") "rosbridge on ROS 2" (standsStill "or does it not listen to geometry_msgs/msg/Twist on /commands/velocity?"),
               story ready rospy "ROS 1" (standsStill "or does it not listen to geometry_msgs/Twist on /mobile_base/commands/velocity?")
             ],
           testGroup "ROS 1 alone" [story ready rospy "a sound that is played at once is heard by a base that begins to listen just then" singsAtOnce, story ready rospy "a node that was killed, and is still in the master, delays nothing" deadListener],
           testGroup
             "a sensor and a command of the program's own"
             [ story ready (rosbridge "1") "rosbridge on ROS 1" (ownTopics (\r -> void (hears (robot r) "subscribed /dock/core")) (pure ())),
               story ready rospy "ROS 1" (\r -> ownTopics (\_ -> mapM_ (agreed r) [("connected", "/dock/core 1"), ("listening", "/report"), ("listening", "/mobile_base/commands/sound")]) (mapM_ (say (robot r)) ["pub /dock/core kobuki_msgs/SensorState", "sub /report geometry_msgs/Twist", "sub /mobile_base/commands/sound kobuki_msgs/Sound"]) r)
             ],
           testGroup
             "rosbridge alone"
             [ story ready (rosbridge "1") "garbage is passed over, and a lost server is found again" (lostServer times),
               story ready (rosbridge "1") "a robot that was lost stands until Enter is pressed" (standsUntilArmed "left" (\r _ -> say (robot r) "drop"))
             ],
           testGroup
             "serial alone"
             [ story ready serial "noise, cut and corrupted packets are passed over, and a pulled cable is found again" (pulledCable times),
               story ready serial "a cable that is pulled in a turn is found again, and the robot stands" pulledInATurn,
               story ready serial "a base that was lost stands until Enter is pressed" (standsUntilArmed "plugged" (\r _ -> say (robot r) "unplug" >> say (robot r) "plug")),
               story ready serial "a line with nothing but noise is silent" (onlyNoise times),
               story ready serial "a base without its guardian stands, and has a new one when it drives again" (withoutGuardian times),
               story ready serial "a guardian that stands still does not keep a program from ending" suspendedGuardian,
               story ready serial "a base that answers no question is not driven" mute,
               story ready serial "it stops in good order on Ctrl-\\" (\r -> driving r "off" "steady" $ \p -> signal p "QUIT" >> sees r "a stop" (stands r) >> exits p 0),
               story ready serial "firmware that speaks another protocol is not driven, and that is final" otherFirmware,
               story ready serial "a base that would stop by itself does so when the cable is pulled" (pulledFromFirmware times)
             ]
         ]

-- | Link, cause and seconds until the robot stood, by its own clock; newest first.
type Times = IORef [(String, String, String)]

-- | As a table, beside what is allowed.
printed :: Times -> IO ()
printed times = do
  measured <- reverse <$> readIORef times
  let links = nub [l | (l, _, _) <- measured]
      causes = nub [c | (_, c, _) <- measured]
      cell l c = case [t | (l', c', t) <- measured, l' == l, c' == c] of
        t : _ -> t
        [] -> ""
      rows = ("seconds until it stood (allowed: 0.7)" : links) : [c : [cell l c | l <- links] | c <- causes]
      widths = map (maximum . map length) (transpose rows)
  unless (null measured) . putStrLn $ unlines ("" : map (unwords . zipWith (\w t -> t ++ replicate (w - length t + 1) ' ') widths) rows)
  hFlush stdout

stories :: [(String, IO Times -> Rig -> IO ())]
stories =
  [ ( "it drives, backs off from a bumper by the safety rules, and stops when the system asks",
      \times r ->
        driving r "on" "steady" $ \p -> do
          bumped r
          sees r "backing off" (backs r)
          standsAfter times r "SIGTERM" (signal p "TERM")
          exits p 0
    ),
    ("a program lights an LED", \_ r -> driving r "off" "lights" $ \_ -> bumped r >> sees r "a red light" (red r)),
    ("it stops on Ctrl-C", \times r -> driving r "off" "steady" $ \p -> standsAfter times r "Ctrl-C" (signal p "INT") >> exits p 0),
    ("it stops in an emergency", \times r -> driving r "off" "steady" $ \p -> standsAfter times r "the emergency stop" (signal p "USR1") >> exits p 0),
    ( "it stops when the program is killed",
      \times r ->
        driving r "off" "steady" $ \p -> do
          standsAfter times r "kill -9" (killPeer p)
          toldToStand r
    ),
    ( "it stops, or is seen to be silent, when the program is suspended, and drives on with it",
      \times r ->
        driving r "off" "steady" $ \p -> do
          standsAfter times r "kill -STOP" (signal p "STOP")
          signal p "CONT"
          sees r "movement again" (moves r)
          standsAfter times r "kill -HUP" (signal p "HUP")
          exits p 0
    ),
    ( "it stops when a function fails",
      \times r ->
        driving r "off" "fails" $ \p -> do
          standsAfter times r "an exception" (bumped r)
          _ <- hearsWhere p "the reason" ("the bumper broke me" `isInfixOf`)
          exits p 2
    ),
    ( "it stops, or is seen to be silent, when a function hangs, and Ctrl-C still ends the program",
      \times r ->
        driving r "off" "hangs" $ \p -> standsAfter times r "a function that hangs" (bumped r) >> signal p "INT" >> exits p 2
    ),
    ("it stops when the program is done", \times r -> driving r "off" "done" $ \p -> standsAfter times r "the program's end" (bumped r) >> exits p 0)
  ]

-- | The messages of a topic reach the program, and its answers the robot's side: the same as in the simulator (test_own_topics.py).
ownTopics :: (Rig -> IO ()) -> IO () -> Rig -> IO ()
ownTopics connected prepare r = do
  prepare
  streaming r
  asProgram r "on" "reports" $ \_ -> do
    connected r
    -- What comes before the program has begun does not reach it (rule R10): the robot repeats its message until there is an answer.
    withAsync (forever (say (robot r) "send /dock/core {\"battery\": 160}" >> threadDelay 200000)) . const $
      sees r "the first report" ("got /report {\"linear\": {\"x\": 160.5, \"y\": 0" `isPrefixOf`)
    say (robot r) "send /dock/core {\"battery\": 120}"
    -- Each topic has a connection of its own on ROS 1, so the order of the two is open.
    let answers = [(== "got /mobile_base/commands/sound {\"value\": 3}"), ("got /report {\"linear\": {\"x\": 120.5, \"y\": " `isPrefixOf`)]
        complete heard = all (`any` heard) answers
    awaitTranscript (robot r) complete
    heard <- transcript (robot r)
    assertBool ("a sound and a second report: " ++ unlines heard) (complete heard)

-- | The ROS node says so too.
agreed :: Rig -> (String, String) -> IO ()
agreed r (what, topic) = say (robot r) (what ++ " " ++ topic) >> void (hears (robot r) (what ++ " " ++ takeWhile (/= ' ') topic))

-- | A program of its own process, from when the robot moves.
driving :: Rig -> String -> String -> (Peer -> IO a) -> IO a
driving r safety name act = streaming r >> asProgram r safety name (\p -> sees r "movement" (moves r) >> act p)

-- | A program of its own process. A busy machine may lose the robot for a moment: then it drives on.
asProgram :: Rig -> String -> String -> (Peer -> IO a) -> IO a
asProgram r = asProgramWith r "&rearm=off"

-- | With further options in the robot's address.
asProgramWith :: Rig -> String -> String -> String -> (Peer -> IO a) -> IO a
asProgramWith r more safety name act = do
  self <- getExecutablePath
  withProgram (environment r) "/bin/sh" ["-c", "exec \"$@\" 2>&1", "sh", self, "--drive", url r ++ "?safety=" ++ safety ++ options r ++ more, name] act

-- | What happens, and how long the robot drives on, by its own clock: until it is told to stand or its watchdog says so. It
-- is printed beside what is allowed and not judged, because this machine may be busy.
standsAfter :: IO Times -> Rig -> String -> IO () -> IO ()
standsAfter times r what act = do
  say (robot r) "mark"
  _ <- hears (robot r) "marked"
  act
  took <- drop 6 <$> hears (robot r) "stood "
  times >>= (`modifyIORef` ((called r, what, took) :))

sees :: Rig -> String -> (String -> Bool) -> IO ()
sees r what = void . hearsWhere (robot r) what

exits :: Peer -> Int -> IO ()
exits p code = exitOf p >>= (@?= if code == 0 then ExitSuccess else ExitFailure code)

-- | It drives without an option, and what it is told has the robot's time.
stampedDrive :: Rig -> IO ()
stampedDrive r = driving r "off" "steady" $ \p -> do
  told <- filter ("got /cmd_vel" `isPrefixOf`) <$> transcript (robot r)
  -- The rig's odometry is of 12.5 s.
  forM_ told $ \l -> assertBool l ("\"header\"" `notElem'` l || any (`isInfixOf` l) ["\"stamp\": {\"sec\": " ++ show s ++ "," | s <- [12 .. 14 :: Int]])
  rejected <- filter ("rejected" `isPrefixOf`) <$> transcript (robot r)
  rejected @?= []
  signal p "TERM"
  exits p 0
  where
    notElem' part whole = not (part `isInfixOf` whole)

-- | It is waited for, found, and asked what it takes.
lateRobot :: Rig -> IO ()
lateRobot r = do
  streaming r
  asProgram r "off" "steady" $ \p -> do
    _ <- hearsWhere p "that there is none yet" ("has no odometry" `isInfixOf`)
    say (robot r) "appear"
    sees r "movement" (moves r)
    -- So is all that was silent.
    awaitTranscript (robot r) (\told -> all ((> 1) . (`times` told)) ["/odom", "/battery_state", "/imu"])
    signal p "TERM"
    exits p 0
  where
    times topic = length . filter (("subscribed " ++ topic ++ " ") `isPrefixOf`)

-- | The odometry of the rigs never changes.
standsStill :: String -> Rig -> IO ()
standsStill why r = driving r "off" "steady" $ \p -> do
  _ <- hearsWhere p "that it does not move" (\l -> "it has been told to drive for a second and does not move." `isInfixOf` l && why `isInfixOf` l)
  signal p "TERM"
  exits p 0

-- | A robot that is not there: the reason in words, and Ctrl-C ends the program.
waiting :: String -> String -> TestTree
waiting address why = testCase address $ do
  self <- getExecutablePath
  here <- plainEnvironment
  withProgram here "/bin/sh" ["-c", "exec \"$@\" 2>&1", "sh", self, "--drive", address, "steady"] $ \p -> do
    _ <- hearsWhere p "how to give up" ("Ctrl-C gives up" `isInfixOf`)
    _ <- hearsWhere p why (why `isInfixOf`)
    signal p "INT"
    _ <- hearsWhere p "that it never ran" ("The program never ran" `isInfixOf`)
    exits p 2

-- | The base's odometry arrives before all that it listens to is connected. The system says who will be.
singsAtOnce :: Rig -> IO ()
singsAtOnce r = do
  prepared r
  streaming r
  asProgram r "off" "sings" $ \_ -> sees r "the sound" (== "got /mobile_base/commands/sound {\"value\": 5}")

-- | The master keeps a node that could not say goodbye.
deadListener :: Rig -> IO ()
deadListener r = do
  withPeer (environment r) "gone" $ \gone -> do
    say gone "sub /mobile_base/commands/velocity geometry_msgs/Twist"
    _ <- hears gone "subscribed"
    killPeer gone
  driving r "off" "steady" $ \p -> do
    told <- transcript p
    filter ("no node publishes odometry" `isInfixOf`) told @?= []
    signal p "TERM"
    exits p 0

lostServer :: IO Times -> Rig -> IO ()
lostServer times r = driving r "off" "steady" $ \p -> do
  forM_ ["raw not json", "raw {\"op\":\"status\",\"level\":\"error\",\"msg\":\"x\"}", "raw {\"op\":\"publish\",\"topic\":\"/mobile_base/events/bumper\",\"msg\":{\"bumper\":9,\"state\":null}}", "raw [1]"] (say (robot r))
  _ <- hearsWhere p "what the server says" ("its server says: x" `isInfixOf`)
  say (robot r) "refuse"
  standsAfter times r "a lost connection" (say (robot r) "drop")
  _ <- hearsWhere p "that it is lost" ("is lost" `isInfixOf`)
  say (robot r) "accept"
  _ <- hearsWhere p "that it is back" ("is back" `isInfixOf`)
  sees r "movement again" (moves r)

-- | Nothing goes to and fro and nothing is closed, as when the cable is pulled between two computers; what was said meanwhile
-- arrives when it is plugged in again. A process that stands still is seen so by the other one.
cutOff :: IO Times -> Rig -> IO ()
cutOff times r = driving r "off" "steady" $ \p -> do
  standsAfter times r "a pulled cable" (signal p "STOP")
  signal p "CONT"
  sees r "movement again" (moves r)
  signal (robot r) "STOP"
  -- On a busy machine it may have been lost and found again before: the last word counts.
  awaitTranscript p (any ("is lost" `isInfixOf`) . take 1 . reverse . filter isNotice)
  signal (robot r) "CONT"
  sees r "a stop behind what was said before" (stands r)
  _ <- hearsWhere p "that it is back" ("is back" `isInfixOf`)
  signal p "TERM"
  exits p 0
  where
    isNotice l = any (`isInfixOf` l) ["is there", "is lost", "is back"]

-- | Yujin documents no time after which the base would stop by itself, so this one drives on.
pulledCable :: IO Times -> Rig -> IO ()
pulledCable times r = driving r "off" "steady" $ \p -> do
  forM_ ["noise", "cut", "corrupt", "noise"] (say (robot r))
  say (robot r) "unplug"
  _ <- hearsWhere p "that it is lost" ("is lost" `isInfixOf`)
  say (robot r) "bump 0"
  say (robot r) "plug"
  -- It may have driven all the time: the first thing that it hears is that it is to stand.
  hearsWhere (robot r) "a stop before anything else" ("first " `isPrefixOf`) >>= (@?= "first 0.000 0.000")
  times >>= (`modifyIORef` ((called r, "a pulled cable", "when plugged in") :))
  _ <- hearsWhere p "that it is back" ("is back" `isInfixOf`)
  signal p "TERM"
  sees r "a stop" (stands r)
  exits p 0

pulledInATurn :: Rig -> IO ()
pulledInATurn r = asProgram r "off" "turns" $ \p -> do
  sees r "a turn" (== "control 0.000 1.000 115 1")
  say (robot r) "unplug"
  _ <- hearsWhere p "that it is lost" ("is lost" `isInfixOf`)
  say (robot r) "plug"
  hearsWhere (robot r) "a stop before anything else" ("first " `isPrefixOf`) >>= (@?= "first 0.000 0.000")
  sees r "the turn again, because the program says so ten times a second" (== "control 0.000 1.000 115 1")
  signal p "TERM"
  exits p 0

-- | Packets arrive all the time, and none is whole.
onlyNoise :: IO Times -> Rig -> IO ()
onlyNoise times r = driving r "off" "steady" $ \p -> do
  standsAfter times r "nothing but noise on the line" (say (robot r) "static")
  _ <- hearsWhere p "that it is lost" ("is lost: it has fallen silent" `isInfixOf`)
  signal p "TERM"
  exits p 0

withoutGuardian :: IO Times -> Rig -> IO ()
withoutGuardian times r = driving r "off" "steady" $ \p -> do
  standsAfter times r "kill -9 of its guardian" (signalChildren p "KILL")
  _ <- hearsWhere p "why" ("is lost: its guardian process has ended" `isInfixOf`)
  sees r "movement again" (moves r)
  standsAfter times r "kill -STOP behind that" (signal p "STOP")
  signal p "CONT"
  sees r "movement again" (moves r)
  signal p "TERM"
  exits p 0

suspendedGuardian :: Rig -> IO ()
suspendedGuardian r = driving r "off" "steady" $ \p -> do
  signalChildren p "STOP"
  signal p "TERM"
  sees r "a stop" (stands r)
  exits p 0

-- | The program commands ten times a second, and all the same the robot stands from this line of its on, until a person agrees.
standsUntilArmed :: String -> (Rig -> Peer -> IO ()) -> Rig -> IO ()
standsUntilArmed since breaks r = do
  answered <- newIORef 0
  streaming r
  asProgramWith r "" "off" "steady" $ \p -> do
    moving answered p
    known <- questions <$> transcript p
    breaks r p
    awaitTranscript p ((> known) . questions)
    told <- reverse . takeWhile (not . isPrefixOf since) . reverse <$> transcript (robot r)
    assertBool (unlines told) (not (any (moves r) told))
    moving answered p
    signal p "TERM"
    exits p 0
  where
    questions = length . filter ("Press Enter here to let it drive again" `isInfixOf`)
    -- A busy machine may lose the robot for a moment, too: every question is answered until it moves.
    moving answered p = do
      known <- length <$> transcript (robot r)
      withAsync (agreeing answered p) $ \_ -> awaitTranscript (robot r) (any (moves r) . drop known)
    agreeing answered p = do
      n <- readIORef answered
      awaitTranscript p ((> n) . questions)
      writeIORef answered (n + 1) >> say p ""
      agreeing answered p

-- | As after a laptop's sleep, or Ctrl-Z and fg: it stood still until the robot stood, and goes on.
frozen :: Rig -> Peer -> IO ()
frozen r p = do
  say (robot r) "mark"
  _ <- hears (robot r) "marked"
  signal p "STOP"
  _ <- hears (robot r) "stood "
  toldToStand r
  signal p "CONT"

-- | On each link the age counts at the write. The light and the movement behind it show that the old movement's turn is over.
decidedBefore :: Rig -> IO ()
decidedBefore r = do
  streaming r
  reached r $ \connection -> do
    awaitConnected connection
    now <- bootSeconds
    sendCommand connection (now - longestAbsence - 1) (VelocityCommand (Velocity 0.2 0))
    sendCommand connection now (Led1Command (Led1 Red))
    sees r "a red light" (red r)
    sendCommand connection (now + 1e6) (VelocityCommand (Velocity (-0.1) 0))
    sees r "a movement of now" (backs r)
    told <- transcript (robot r)
    assertBool (unlines told) (not (any (moves r) told))
  where
    awaitConnected connection = do
      events <- atomically (takeEvents connection)
      unless (Connected `elem` events) (awaitConnected connection)

-- | Its guardian told it so: it does not only stand by its own watchdog.
toldToStand :: Rig -> IO ()
toldToStand r = awaitTranscript (robot r) (any (stands r) . takeWhile (not . moves r) . reverse)

mute :: Rig -> IO ()
mute r = do
  say (robot r) "mute"
  asProgram r "off" "steady" $ \p -> do
    sees r "a question" (== "versions asked")
    _ <- hearsWhere p "why it is not driven" ("it does not say which firmware it has" `isInfixOf`)
    neverMoved r
    signal p "TERM"
    exits p 2

otherFirmware :: Rig -> IO ()
otherFirmware r = do
  say (robot r) "firmware 2"
  asProgram r "off" "steady" $ \p -> do
    _ <- hearsWhere p "why it is not driven" ("cannot be driven: its firmware 2.2.0 speaks another protocol" `isInfixOf`)
    exits p 2
    neverMoved r

-- | It was told no speed but zero.
neverMoved :: Rig -> IO ()
neverMoved r = do
  told <- filter ("control " `isPrefixOf`) <$> transcript (robot r)
  assertBool (unlines told) (all (stands r) told)

-- | Some firmware may have a timeout as kobuki_node has. Then it stops the base.
pulledFromFirmware :: IO Times -> Rig -> IO ()
pulledFromFirmware times r = driving r "off" "steady" $ \p -> do
  say (robot r) "timeout 0.6"
  standsAfter times r "the same, firmware with kobuki_node's limit" (say (robot r) "unplug")
  signal p "TERM"
  exits p 0
