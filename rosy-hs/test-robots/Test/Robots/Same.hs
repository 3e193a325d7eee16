{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : The same program and the same sensor stream give the same commands on every link.
--
-- The stream was made from packets of the base. It goes through the simulator's pipe, through a robot in the simulator's
-- place, through a rosbridge server of either kind, through ROS 1 and down a serial line; each time the same program
-- answers, and what the robot was told must be what the simulator was told.
module Test.Robots.Same (tests) where

import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM
import Control.Exception (bracket, finally)
import Control.Monad (forM, forM_, void)
import Data.Aeson (Value (..), (.:))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (parseMaybe)
import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import qualified Data.ByteString.Lazy.Char8 as LC
import Data.IORef
import Data.List (group, stripPrefix)
import Data.Maybe (mapMaybe)
import Foreign.Ptr (nullPtr)
import Network.Socket (Family (..), Socket, SocketType (..), close, defaultProtocol, socketPair, withFdSocket)
import Network.Socket.ByteString (recv)
import Network.Socket.ByteString.Lazy (sendAll)
import Rosy.Controller (Names (..))
import Rosy.Core (Action (..), Message (..), Odometry (..))
import Rosy.Kobuki.Command (wheelCommand)
import Rosy.Kobuki.Feedback (Core (..), Inertia (..))
import Rosy.Kobuki.Sensing
import Rosy.Link (Link)
import Rosy.Link.Pipe (pipeLink)
import Rosy.Link.Real
import Rosy.Robot
import Rosy.Robots.Base
import Rosy.Robots.Drive (withBase)
import Rosy.Robots.Guard
import Rosy.Robots.Pipe
import Rosy.Robots.Serve (onTerminal, serve)
import Rosy.Robots.Target
import Rosy.Run (runOn)
import Rosy.Runnable (program)
import System.Posix.IO (FdOption (..), setFdOption)
import System.Posix.Types (Fd (..))
import System.Timeout (timeout)
import Test.Robots.Kobuki (corePacket)
import Test.Robots.Programs (follow, lights, sounds)
import Test.Robots.Rigs
import Test.Ros.Peer
import Test.Tasty
import Test.Tasty.HUnit

tests :: Ready -> TestTree
tests ready =
  localOption (mkTimeout 60000000) $
    testGroup
      "the same stream gives the same commands"
      [ testCase "a robot in the simulator's place" inPlace,
        story ready (rosbridge "1") "rosbridge on ROS 1" (jsonRobot "/mobile_base"),
        story ready (rosbridge "2") "rosbridge on ROS 2" (jsonRobot ""),
        story ready rospy "ROS 1" (jsonRobot "/mobile_base"),
        story ready serial "serial" serialRobot
      ]

-- | Half a second of a drive: faster and faster, with bumps, a hole and a button.
recorded :: [(Core, [Message])]
recorded = zip cores (go unsensed cores)
  where
    go s cs = case cs of
      [] -> []
      c : rest -> let (ms, s') = sense c (Just (Inertia 0 0)) s in ms : go s' rest
    cores =
      [ Core
          { timeStamp = fromIntegral (65400 + 20 * i),
            bumpers = if i `elem` [5 .. 8] then 4 else if i == 12 then 3 else 0,
            wheelDrops = 0,
            cliffs = if i `elem` [14, 15] then 2 else 0,
            leftEncoder = ticks i,
            rightEncoder = ticks i,
            buttons = if i `elem` [17, 18] then 1 else 0,
            battery = 160
          }
        | i <- [0 .. 24 :: Int]
      ]
    ticks i = fromIntegral (65000 + 10 * i + 3 * i * (i - 1) `div` 2)

steps :: [[Message]]
steps = map snd recorded

-- | The program, on a link.
running :: Link -> IO ()
running link = runOn link (program (Names []) (lights, sounds, follow))

-- | What the simulator is told, step by step.
reference :: IO [[Action]]
reference = withProgramAtPipe $ \socket -> do
  next <- lineReader socket
  say' socket (startLine 1)
  void (wishes next)
  answers <- forM (zip [0 ..] steps) $ \(n, ms) -> say' socket (batchLines n (fromIntegral n / 50) ms) >> wishes next
  say' socket stopLine
  void (wishes next)
  pure answers
  where
    wishes next = do
      l <- next
      case readWish l of
        Just (Wants a) -> (a :) <$> wishes next
        Just NamesTopics -> wishes next
        Just _ -> pure []
        Nothing -> assertFailure (show l)

say' :: Socket -> Builder.Builder -> IO ()
say' s = sendAll s . Builder.toLazyByteString

lineReader :: Socket -> IO (IO B.ByteString)
lineReader s = do
  rest <- newIORef B.empty
  let next = do
        bytes <- readIORef rest
        case C.elemIndex '\n' bytes of
          Just i -> B.take i bytes <$ writeIORef rest (B.drop (i + 1) bytes)
          Nothing -> do
            more <- recv s 65536
            if B.null more then assertFailure "the program has left" else writeIORef rest (bytes <> more) >> next
  pure next

-- | The program waits for a simulator at the other end.
withProgramAtPipe :: (Socket -> IO a) -> IO a
withProgramAtPipe use = bracket (socketPair AF_UNIX Stream defaultProtocol) (\(a, b) -> close a >> close b) $ \(ours, theirs) ->
  withFdSocket theirs $ \fd -> do
    -- The pipe link reads as a process does that was forked a moment ago: it blocks, and ends when the other side closes.
    setFdOption (Fd fd) NonBlockingRead False
    withAsync (pipeLink fd nullPtr >>= running) (const (use ours `finally` close ours))

inPlace :: Assertion
inPlace = do
  expected <- reference
  told <- newTVarIO []
  hearing' <- newHearing
  stop <- newTVarIO False
  guarded <- newTVarIO (newGuard (Limits 0.7 pi) False)
  let base = Base "a robot" (\a -> atomically (modifyTVar' told (a :))) (hearAll hearing')
  withProgramAtPipe $ \socket -> withAsync (serve (onTerminal "a robot") (readTVar stop) 10 guarded base socket) $ \_ -> do
    atomically (heard hearing' Here)
    forM_ (zip steps expected) $ \(ms, actions) -> do
      atomically (mapM_ (heard hearing' . Heard) ms)
      awaiting (atomically (readTVar told >>= check . any (`elem` velocities actions)))
    got <- reverse <$> readTVarIO told
    once (velocities got) @?= once (velocities (concat expected))
    others got @?= others (concat expected)

velocities, others :: [Action] -> [Action]
velocities as = [a | a@(SetVelocity _ _) <- as]
others as = [a | a <- as, a `notElem` velocities as]

-- | Repetitions of what was said are no new commands.
once :: Eq a => [a] -> [a]
once = concatMap (take 1) . group

awaiting :: IO () -> IO ()
awaiting act = timeout 20000000 act >>= maybe (assertFailure "the robot was not told") pure

-- | The program on a robot at this address.
driven :: Rig -> IO a -> IO a
driven r act = do
  target <- either (assertFailure . explainTargetError) pure (readTarget (url r ++ "?safety=off" ++ options r))
  reins <- newReins (newGuard (targetLimits target) False)
  withClock $ \clock -> withBase target $ \base -> do
    link <- realLink clock 10 reins base
    withAsync (running link) (const act)

-- | Messages go in as JSON, and commands come out so.
jsonRobot :: String -> Rig -> IO ()
jsonRobot prefix' r = do
  expected <- reference
  prepared r
  driven r $ do
    attached r
    -- Each topic travels by itself: what an event leads to is awaited before the next, which could overtake it.
    forM_ (zip3 steps expected (scanl1 (+) (map (length . others) expected))) $ \(ms, actions, soFar) -> do
      mapM_ (say (robot r)) (mapMaybe sending ms)
      forM_ (velocities actions) $ \v -> hearsWhere (robot r) (show v) ((== Just v) . command')
      awaiting (untilAll soFar)
  got <- mapMaybe command' <$> transcript (robot r)
  let untilStop = takeWhile (/= SetVelocity 0 0) (once (velocities got))
  untilStop @?= once (velocities (concat expected))
  [a | a@(SetLed1 _) <- got] @?= [a | a@(SetLed1 _) <- concat expected]
  [a | a@(PlaySound _) <- got] @?= [a | a@(PlaySound _) <- concat expected]
  where
    untilAll n = do
      got <- mapMaybe command' <$> transcript (robot r)
      if length (others got) >= n then pure () else untilAll n
    command' line = do
      rest <- stripPrefix ("got " ++ prefix' ++ "/commands/") line
      let (topic, text) = break (== ' ') rest
      Object o <- Aeson.decode (LC.pack text)
      case topic of
        "velocity" -> parseMaybe (\m -> SetVelocity <$> (m .: "linear" >>= (.: "x")) <*> (m .: "angular" >>= (.: "z"))) o
        "led1" -> SetLed1 . toEnum <$> parseMaybe (.: "value") o
        "sound" -> PlaySound . toEnum <$> parseMaybe (.: "value") o
        _ -> Nothing
    sending m = case m of
      OdometryMessage o -> Just ("send /odom " ++ odometryJson o)
      BumperMessage (Bumper n s) -> Just (event "bumper" ("{\"bumper\": " ++ show (fromEnum n) ++ ", \"state\": " ++ show (fromEnum (s == Pressed)) ++ "}"))
      CliffMessage (Cliff n s) -> Just (event "cliff" ("{\"sensor\": " ++ show (fromEnum n) ++ ", \"state\": " ++ show (fromEnum (s == Hole)) ++ ", \"bottom\": 0}"))
      ButtonMessage (Button n s) -> Just (event "button" ("{\"button\": " ++ show (fromEnum n) ++ ", \"state\": " ++ show (fromEnum (s == Pressed)) ++ "}"))
      _ -> Nothing
    event topic text = "send " ++ prefix' ++ "/events/" ++ topic ++ " " ++ text

-- | Packets go in, and the wheels' speeds come out as the base encodes them.
serialRobot :: Rig -> IO ()
serialRobot r = do
  expected <- reference
  prepared r
  driven r . forM_ (zip recorded expected) $ \((core, _), actions) -> do
    say (robot r) ("replay " ++ concatMap hex (B.unpack (corePacket core 0)))
    forM_ (velocities actions) $ \v -> hearsWhere (robot r) (show v) ((== control v) . speeds)
  got <- transcript (robot r)
  takeWhile (/= "0 0") [speeds l | l <- got, take 8 l == "control "] @?= once (map control (velocities (concat expected)))
  [l | l <- got, take 5 l == "led1 "] @?= ("led1 0" : once [light c | SetLed1 c <- concat expected])
  [l | l <- got, take 6 l == "sound "] @?= ["sound " ++ show (fromEnum s) | PlaySound s <- concat expected]
  where
    hex b = let t = L.unpack (Builder.toLazyByteString (Builder.word8HexFixed b)) in map (toEnum . fromIntegral) t
    light c = "led1 " ++ show (case c of Black -> 0 :: Int; Red -> 1; Green -> 2; Orange -> 3)
    -- Speed and radius are the last words.
    speeds = unwords . drop 3 . words
    control a = case a of
      SetVelocity v w -> let (s, radius) = wheelCommand v w in unwords [show s, show radius]
      _ -> ""

-- | All that the program's odometry is made of.
odometryJson :: Odometry -> String
odometryJson (Odometry (Position x y) _ (Velocity v w)) =
  ("{\"pose\": {\"pose\": {\"position\": {\"x\": " ++ show x ++ ", \"y\": " ++ show y ++ ", \"z\": 0.0}, ")
    ++ "\"orientation\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0, \"w\": 1.0}}}, "
    ++ ("\"twist\": {\"twist\": {\"linear\": {\"x\": " ++ show v ++ ", \"y\": 0.0, \"z\": 0.0}, \"angular\": {\"x\": 0.0, \"y\": 0.0, \"z\": " ++ show w ++ "}}}}")
