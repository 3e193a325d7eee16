{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : The same programs move a base in the same way on every link and in the simulator.
--
-- @protocol/goldens/motion.jsonl@ says which programs, which buttons are pressed when, and where the simulated robot is each second
-- (@test_same_motion.py@). Here a base with the limits of a Kobuki is moved by what arrives at the other end of each link: its
-- odometry goes to the program, the program's velocities come back, and the base stops when it has heard none for 0.6 s. Time is
-- simulated. The base's own tolerance is that of its encoders and gyroscope, and of a command that arrives a step later.
module Test.Robots.Motion (tests) where

import Control.Concurrent.Async (wait, waitSTM, withAsync)
import Control.Concurrent.STM
import Control.Monad (forM_, unless, void, when)
import Data.Aeson ((.:))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (Parser, parseEither)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Data.IORef
import Rosy.Channel (Action, Message)
import Rosy.Kobuki.Command (wheelCommand)
import Rosy.Kobuki.Feedback (Core (..), Inertia (..))
import Rosy.Kobuki.Sensing
import Rosy.Link.Mailbox (noMailbox)
import Rosy.Robot
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.LockstepRun (Observer (onNotice), Pace (..), onTerminal, runLockstep)
import Rosy.Sentence (verbatim)
import Test.Robots.Kobuki (corePacket, senseCore)
import qualified Test.Robots.Motion.EventOnly
import qualified Test.Robots.Motion.Periodic
import qualified Test.Robots.Motion.Tasks
import qualified Test.Robots.Motion.Timed
import Test.Robots.Played
import Test.Robots.Recorded (isTold, ticksAt, timeOf)
import Test.Robots.Rigs
import Test.Robots.Same (commandOf, hexadecimal, messageTo, reached, withProgramAtPipe)
import Test.Ros.Peer
import Test.Tasty
import Test.Tasty.HUnit

tests :: Ready -> TestTree
tests ready =
  localOption (mkTimeout 900000000) $
    testGroup
      "the same programs move the base in the same way"
      [ testCase "the pipe" (table >>= mapM_ overPipe),
        story ready (rosbridge "1") "rosbridge on ROS 1" (overJson "/mobile_base"),
        story ready (rosbridge "2") "rosbridge on ROS 2" (overJson ""),
        story ready rospy "ROS 1" (overJson "/mobile_base"),
        story ready serial "serial" overSerial
      ]

-- ---------------------------------------------------------------------------------------------
-- The table

data Row = Row
  { program :: String,
    seconds :: Double,
    -- | when, seconds; which button; whether it is pressed
    presses :: [(Double, Int, Bool)],
    -- | x, y (m) and heading (rad) each second
    poses :: [(Double, Double, Double)]
  }

table :: IO [Row]
table = C.readFile "protocol/goldens/motion.jsonl" >>= mapM (either assertFailure pure . read') . C.lines
  where
    read' bytes = Aeson.eitherDecodeStrict' bytes >>= parseEither row
    row :: Aeson.Object -> Parser Row
    row o = Row <$> o .: "program" <*> o .: "seconds" <*> o .: "presses" <*> o .: "poses"

mainOf :: Row -> IO ()
mainOf row = case program row of
  "EventOnly" -> Test.Robots.Motion.EventOnly.main
  "Periodic" -> Test.Robots.Motion.Periodic.main
  "Tasks" -> Test.Robots.Motion.Tasks.main
  "Timed" -> Test.Robots.Motion.Timed.main
  other -> assertFailure ("no program is called " ++ other)

-- | Metres and radians between the pose on a link and that in the simulator.
tolerance :: (Double, Double)
tolerance = (0.01, 0.02)

compared :: String -> Row -> [Moved] -> Assertion
compared link row path = do
  let each = [m | (i, m) <- zip [0 :: Int ..] path, i `mod` 50 == 0]
      far (m, (x, y, a)) = sqrt ((x - metresX m) ^ (2 :: Int) + (y - metresY m) ^ (2 :: Int)) > fst tolerance || abs (a - heading m) > snd tolerance
      pairs = zip each (poses row)
  assertBool (link ++ " " ++ program row ++ ": too short") (length pairs >= length (poses row) - 1 && length pairs > 2)
  forM_ pairs $ \pair@(m, pose) ->
    when (far pair) . assertFailure $
      concat [link, ", ", program row, ": the base is at ", show (metresX m, metresY m, heading m), " and in the simulator at ", show pose]

-- ---------------------------------------------------------------------------------------------
-- The base

data Moved = Moved
  { metresX, metresY, heading, linear, angular :: Double,
    -- | how far each wheel has turned, m
    leftWay, rightWay :: Double,
    -- | the velocity that the base was told last, and how many steps ago
    asked :: (Double, Double),
    age :: Int
  }

unmoved :: Moved
unmoved = Moved 0 0 0 0 0 0 0 (0, 0) 0

-- | A step of 20 ms, in which the base was told this. Accelerations, m/s² and rad/s², and the timeout of commands stand in
-- protocol/robots/kobuki.json.
moved :: Maybe (Double, Double) -> Moved -> Moved
moved new before =
  b
    { metresX = metresX b + v * cos middle * dt,
      metresY = metresY b + v * sin middle * dt,
      heading = heading b + w * dt,
      linear = v,
      angular = w,
      leftWay = leftWay b + (v - w * 0.115) * dt,
      rightWay = rightWay b + (v + w * 0.115) * dt,
      age = age b + 1
    }
  where
    b = maybe before (\velocity -> before {asked = velocity, age = 0}) new
    (wantedV, wantedW) = if age b >= 30 then (0, 0) else asked b
    v = approach 2 wantedV (linear b)
    w = approach 7 wantedW (angular b)
    middle = heading b + w * dt / 2
    approach a target x = max (x - a * dt) (min (x + a * dt) target)
    dt = 0.02

-- | The packet of the base at a step, and the messages that are made of it.
packetAt :: Row -> Int -> Moved -> Sensing -> (B.ByteString, [Message], Sensing)
packetAt row n m s = (corePacket core inertia, filter isTold ms, s')
  where
    (ms, s') = senseCore core (Just inertia) s
    core =
      Core
        { timeStamp = fromIntegral (20 * n),
          bumpers = 0,
          wheelDrops = 0,
          cliffs = 0,
          leftEncoder = ticks (leftWay m),
          rightEncoder = ticks (rightWay m),
          buttons = sum [2 ^ button | button <- [0 .. 2 :: Int], isDown button]
        }
    inertia = Inertia (fromIntegral (hundredths (heading m))) (fromIntegral (hundredths (angular m)))
    isDown button = or (take 1 (reverse [down | (at', b, down) <- presses row, b == button, at' <= timeOf n + 1e-9]))
    ticks way = fromIntegral (round (way / metresPerTick :: Double) :: Int)
    hundredths a = round (a * 18000 / pi) :: Int

-- ---------------------------------------------------------------------------------------------
-- The links

-- | Steps until the time of a row is over.
stepsOf :: Row -> Int
stepsOf row = round (seconds row * 50) + 1

velocityOf :: Action -> Maybe (Double, Double)
velocityOf a = case a of
  VelocityCommand (Velocity v w) -> Just (v, w)
  _ -> Nothing

-- | A base that notes what it was told since it was asked last.
noting :: Connection -> IO (Connection, IO (Maybe (Double, Double)))
noting base = do
  news <- newIORef Nothing
  let told a = forM_ (velocityOf a) (writeIORef news . Just)
  pure (base {sendCommand = \t a -> told a >> sendCommand base t a}, atomicModifyIORef' news (Nothing,))

-- | Plays a row: the way of the base, one place for each step. The first action sends a packet or its messages, and returns when the program has answered; the second
-- waits until a new velocity has arrived at the robot.
played :: Row -> Connection -> Bool -> (Hands -> B.ByteString -> [Message] -> IO ()) -> ((Double, Double) -> IO ()) -> IO [Moved]
played row base known sends arrives = do
  (noted, news) <- noting base
  path <- newIORef []
  let go hands n m s
        | n >= stepsOf row = pure ()
        | otherwise = do
          ended <- isOver hands
          let (bytes, ms, s') = packetAt row n m s
          unless ended $ do
            at hands n
            sends hands bytes (ms ++ [RobotStatusMessage Online | n == 0])
            when (ticksAt n) (tick hands)
          new <- news
          forM_ new (\velocity -> unless (velocity == asked m) (arrives velocity))
          modifyIORef' path (m :)
          go hands (n + 1) (moved new m) s'
  _ <- playing (mainOf row) noted known (\hands -> go hands 0 unmoved unsensed)
  reverse <$> readIORef path

overJson :: String -> Rig -> IO ()
overJson prefix' r = do
  rows <- table
  prepared r
  reached r $ \base -> forM_ (zip rows (False : repeat True)) $ \(row, known) -> do
    before <- length <$> transcript (robot r)
    attachedOnce <- newIORef known
    let sends hands _ ms = do
          there <- readIORef attachedOnce
          unless there (attached r >> writeIORef attachedOnce True)
          -- Each topic travels by itself, so a message is answered before the next is sent.
          forM_ ms $ \m -> say (robot r) (messageTo prefix' m) >> answers hands 1
        arrives velocity = awaitTranscript (robot r) $ \ls ->
          take 1 (reverse [v | Just (VelocityCommand v) <- map (commandOf prefix') (drop before ls)]) `near` velocity
    played row base known sends arrives >>= compared (called r) row
  where
    near found (v, w) = and ([abs (v - v') < 1e-9 && abs (w - w') < 1e-9 | Velocity v' w' <- found] ++ [not (null found)])

-- | The base is plugged in anew for each program.
overSerial :: Rig -> IO ()
overSerial r = do
  rows <- table
  prepared r
  forM_ rows $ \row -> do
    mapM_ (say (robot r)) ["unplug", "plug"]
    _ <- hears (robot r) "plugged"
    before <- length <$> transcript (robot r)
    attachedOnce <- newIORef False
    let sends hands bytes ms = do
          there <- readIORef attachedOnce
          unless there (attached r >> writeIORef attachedOnce True)
          say (robot r) ("replay " ++ hexadecimal bytes)
          answers hands (length ms)
        -- A packet of the base is answered by the speed in force.
        arrives (v, w) = do
          say (robot r) "nudge"
          awaitTranscript (robot r) $ \ls ->
            take 1 (reverse [drop 2 speeds | "control" : speeds <- map words (drop before ls)]) `elem` ([words (uncurry shown (uncurry wheelCommand (withinWheels (Wheels 0.7 0.23) (v, w))))] : [[] | (v, w) == (0, 0)])
    path <- reached r (\base -> played row base False sends arrives)
    compared (called r) row path
  where
    shown speed radius = unwords [show speed, show radius]

-- | A robot in the simulator's place.
overPipe :: Row -> Assertion
overPipe row = do
  begun <- newTVarIO 0
  released <- newTVarIO 0
  heard' <- newEventQueue
  stop <- newTVarIO False
  guarded <- newTVarIO (newGuard (Limits 0.7 pi (Just (Wheels 0.7 0.23))) False)
  (base, news) <- noting (Connection (verbatim "a robot") [] (const (pure [])) (\_ _ -> pure ()) (pure ()) (\_ _ -> pure ()) (awaitEvents heard') (unreadableSoFar heard') (pure Nothing))
  path <- newIORef []
  let observer = (onTerminal (verbatim "a robot")) {onNotice = const (pure ())}
      pace =
        Pace
          { newSeed = pure 1,
            timeOfDay = pure 0,
            timeNow = timeOf . subtract 1 <$> readTVarIO begun,
            awaitStep = atomically (modifyTVar' begun (+ 1)) >> atomically ((>=) <$> readTVar released <*> readTVar begun >>= check),
            stepTimeout = 120
          }
      hears' = mapM_ (enqueue heard' . Received)
      go running n m s
        | n >= stepsOf row = atomically (writeTVar stop True >> writeTVar released (maxBound :: Int))
        | otherwise = do
          let (_, ms, s') = packetAt row n m s
          -- The step before is over when this one waits to begin; a run may be over before.
          awaiting (atomically ((readTVar begun >>= check . (== n + 1)) `orElse` void (waitSTM running)))
          atomically (unless (n == 0) (hears' ms) >> writeTVar released (n + 1))
          awaiting (atomically ((readTVar begun >>= check . (> n + 1)) `orElse` void (waitSTM running)))
          new <- news
          modifyIORef' path (m :)
          go running (n + 1) (moved new m) s'
      (_, first, _) = packetAt row 0 unmoved unsensed
  withProgramAtPipe noMailbox (mainOf row) $ \socket -> do
    atomically (enqueue heard' Connected >> hears' (first ++ [RobotStatusMessage Online]))
    withAsync (runLockstep pace observer (readTVar stop) Nothing 10 guarded base socket) $ \running -> do
      go running 0 unmoved unsensed
      awaiting (void (wait running))
  readIORef path >>= compared "the pipe" row . reverse
