{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Description : The same program and the same sensor stream give the same commands on every link.
--
-- The stream was made from packets of the base. It goes through the simulator's pipe, through its mailbox, through a robot in the simulator's
-- place, through a rosbridge server of either kind, through ROS 1 and down a serial line, with the same chance and the same
-- time; each time the same programs answer, and what the robot was told must be what the simulator was told.
module Test.Robots.Same
  ( tests,

    -- * For other streams
    commandOf,
    messageTo,
    reached,
    withProgramAtPipe,
    hexadecimal,
  )
where

import Control.Applicative ((<|>))
import Control.Concurrent (threadWaitRead)
import Control.Concurrent.Async (wait, waitSTM, withAsync)
import Control.Concurrent.STM
import Control.Exception (bracket, finally)
import Control.Monad (forM_, unless, void, when)
import Data.Aeson (Value (..), (.:))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (parseMaybe)
import Data.Bifunctor (first)
import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy.Char8 as LC
import qualified Data.ByteString.Unsafe as Unsafe
import Data.IORef
import Data.List (group, intercalate, stripPrefix)
import Data.Maybe (isJust, mapMaybe)
import qualified Data.Text as T
import Data.Word (Word32)
import Foreign.Marshal.Alloc (callocBytes, free)
import Foreign.Marshal.Utils (copyBytes)
import Foreign.Ptr (Ptr, nullPtr, plusPtr)
import Foreign.Storable (peek, poke)
import Network.Socket (Family (..), Socket, SocketType (..), close, defaultProtocol, socketPair, withFdSocket)
import Network.Socket.ByteString (recv)
import Network.Socket.ByteString.Lazy (sendAll)
import Rosy.Channel (Action (..), Field (..), Message)
import Rosy.Kobuki.Command (wheelCommand)
import Rosy.Launch (onLink)
import Rosy.Link.Mailbox (Mailbox, noMailbox)
import Rosy.Link.Pipe (pipeLink)
import Rosy.Robot
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.LockstepRun (Observer (onNotice, onProgramCommand), Pace (..), onTerminal, runLockstep)
import Rosy.Robots.PipeCodec
import Rosy.Robots.RobotRun (withConnection)
import Rosy.Robots.Target
import Rosy.Sentence (english, verbatim)
import Rosy.Topic (pattern OpenMessage)
import System.Posix.IO (FdOption (..), setFdOption)
import System.Posix.Types (Fd (..))
import System.Timeout (timeout)
import qualified Test.Robots.Paper.Accelerate
import qualified Test.Robots.Paper.AccelerateAndPlay
import qualified Test.Robots.Paper.DrawSquare
import qualified Test.Robots.Paper.ForwardBackward
import qualified Test.Robots.Paper.Mux
import qualified Test.Robots.Paper.RandomWalk
import qualified Test.Robots.Paper.SafeRandomWalk
import qualified Test.Robots.Paper.SafetyControl
import Test.Robots.Played
import Test.Robots.Programs (afterOneAnother, functions, remembering)
import Test.Robots.Recorded
import Test.Robots.Rigs
import Test.Ros.Peer
import Test.Tasty
import Test.Tasty.HUnit

tests :: Ready -> TestTree
tests ready =
  localOption (mkTimeout 900000000) $
    testGroup
      "the same stream gives the same commands"
      [ testCase "the stream has something for every program, and they answer it differently" differ,
        testCase "in the mailbox, until the last line, which comes over the link" $
          forM_ (take 3 plays) (\(name, play) -> reference play >>= \wanted -> inMailbox play >>= assertEqual name wanted),
        testCase "a robot in the simulator's place" (forM_ plays inPlace),
        story ready (rosbridge "1") "rosbridge on ROS 1" (jsonRobot (kobuki "/mobile_base")),
        story ready (rosbridge "2") "rosbridge on ROS 2" (jsonRobot (kobuki "")),
        story ready rospy "ROS 1" (jsonRobot (kobuki "/mobile_base")),
        story ready (ros2Robot "create3" [] "") "a Create 3" (jsonRobot create3),
        story ready (ros2Robot "turtlebot3" [] "") "a TurtleBot 3" (jsonRobot turtlebot3),
        story ready (ros2Robot "turtlebot3" ["stamped"] "&stamped=on") "a TurtleBot 3 that takes velocities with a time" (jsonRobot turtlebot3),
        story ready serial "serial" serialRobot
      ]

-- | Programs by their names. 'onLink' keeps its robot in one place for the whole process, so they run one after another.
plays :: [(String, IO ())]
plays =
  [ ("functions", functions),
    ("memory, events, chance and time", remembering),
    ("tasks", afterOneAnother),
    ("accelerate", Test.Robots.Paper.Accelerate.main),
    ("accelerateAndPlay", Test.Robots.Paper.AccelerateAndPlay.main),
    ("forwardBackward", Test.Robots.Paper.ForwardBackward.main),
    ("safetyControl", Test.Robots.Paper.SafetyControl.main),
    ("mux", Test.Robots.Paper.Mux.main),
    ("randomWalk", Test.Robots.Paper.RandomWalk.main),
    ("safeRandomWalk", Test.Robots.Paper.SafeRandomWalk.main),
    ("drawSquare", Test.Robots.Paper.DrawSquare.main)
  ]

-- | What the simulator is told.
reference :: IO () -> IO [Action]
reference main' = withProgramAtPipe noMailbox main' $ \socket -> do
  talk <- lineReader (recv socket 65536)
  converse (say' socket) (say' socket) talk

-- | What the simulator is told in the mailbox.
inMailbox :: IO () -> IO [Action]
inMailbox main' = bracket (callocBytes 65536) free $ \box -> withProgramAtPipe box main' $ \socket -> do
  -- Where the words, batches and answers stand: protocol/README.md, section 2.
  let word at = box `plusPtr` at :: Ptr Word32
      put batch = do
        let bytes = LC.toStrict (Builder.toLazyByteString batch)
        Unsafe.unsafeUseAsCStringLen bytes (uncurry (copyBytes (box `plusPtr` 4096)))
        poke (word 0) (fromIntegral (B.length bytes))
      -- The first line and the last come over the link. Reading is outside of the time limit, which could lose what was read.
      look = do
        size <- peek (word 64)
        if size == 0
          then timeout 2000 (withFdSocket socket (threadWaitRead . Fd)) >>= maybe look (\() -> recv socket 65536)
          else B.packCStringLen (box `plusPtr` 32768, fromIntegral size) <* poke (word 64) 0
  poke (word 128) 1
  lineReader look >>= converse (say' socket) put

-- | Tell a program the recorded messages; gives what it commands. The first action says the first line and the last, the second one a batch.
converse :: (Builder.Builder -> IO ()) -> (Builder.Builder -> IO ()) -> IO B.ByteString -> IO [Action]
converse say put talk = do
  let wishes = do
        l <- talk
        case readProgramLine l of
          Just (Commands a) -> first (a :) <$> wishes
          Just (DeclaresTopic _) -> wishes
          Just (HasEnded {}) -> pure ([], True)
          Just _ -> pure ([], False)
          Nothing -> assertFailure (show l)
      go n = \case
        [] -> say stopLine >> fst <$> wishes
        ms : rest -> do
          put (batchLines noQuestions n (timeOf n) ms)
          (as, ended) <- wishes
          (as ++) <$> if ended then pure [] else go (n + 1) rest
  say (startLine 1 0)
  _ <- wishes
  go 0 (starting (map snd recorded))

say' :: Socket -> Builder.Builder -> IO ()
say' s = sendAll s . Builder.toLazyByteString

-- | Lines, from an action that gives more bytes.
lineReader :: IO B.ByteString -> IO (IO B.ByteString)
lineReader receive = do
  rest <- newIORef B.empty
  let next' = do
        bytes <- readIORef rest
        case C.elemIndex '\n' bytes of
          Just i -> B.take i bytes <$ writeIORef rest (B.drop (i + 1) bytes)
          Nothing -> do
            more <- receive
            if B.null more then assertFailure "the program has left" else writeIORef rest (bytes <> more) >> next'
  pure next'

-- | The program waits for a simulator at the other end.
withProgramAtPipe :: Mailbox -> IO () -> (Socket -> IO a) -> IO a
withProgramAtPipe box main' use = bracket (socketPair AF_UNIX Stream defaultProtocol) (\(a, b) -> close a >> close b) $ \(ours, theirs) ->
  withFdSocket theirs $ \fd -> do
    -- The pipe link reads as a process does that was forked a moment ago: it blocks, and ends when the other side closes.
    setFdOption (Fd fd) NonBlockingRead False
    withAsync (pipeLink fd nullPtr box >>= (`onLink` main')) (const (use ours `finally` close ours))

-- ---------------------------------------------------------------------------------------------
-- Comparing

differ :: Assertion
differ = do
  all' <- mapM (reference . snd) plays
  forM_ (zip plays all') $ \((name, _), as) -> assertBool (name ++ " does little: " ++ show (once as)) (length (once as) > 2)
  let used = concat all'
  forM_ (map (Led1Command . Led1) [Black ..] ++ map (Led2Command . Led2) [Black ..] ++ map SoundCommand [OnSound, OffSound, ErrorSound, CleaningStartSound]) $ \a ->
    assertBool (show a) (a `elem` used)
  forM_ (zip all' (drop 1 all')) $ \(a, b) -> assertBool "two programs do the same" (a /= b)

-- | What goes its own way to the robot; between them there is no order.
channels :: [(String, Action -> Bool)]
channels =
  [ ("velocity", isVelocity),
    ("LED 1", \case Led1Command (Led1 _) -> True; _ -> False),
    ("LED 2", \case Led2Command (Led2 _) -> True; _ -> False),
    ("sound", \case SoundCommand _ -> True; _ -> False),
    ("words", \case SayCommand (Say _) -> True; _ -> False)
  ]

isVelocity :: Action -> Bool
isVelocity a = case a of
  VelocityCommand (Velocity _ _) -> True
  _ -> False

-- | The same in every channel. A heading that went through a quaternion is another in its last digit.
sameAs :: String -> [Action] -> [Action] -> Assertion
sameAs who got expected = forM_ channels $ \(channel, is) -> do
  let g = filter is got
      e = filter is expected
      same = length (takeWhile id (zipWith near g e))
  unless (length g == length e && same == length g) $
    assertFailure (unlines [who ++ ", " ++ channel ++ ", from number " ++ show same, "expected: " ++ show (take 5 (drop same e)), " but got: " ++ show (take 5 (drop same g))])

near :: Action -> Action -> Bool
near (VelocityCommand (Velocity v w)) (VelocityCommand (Velocity v' w')) = abs (v - v') < 1e-9 && abs (w - w') < 1e-9
near a b = a == b

-- | Repetitions of what was said are no new commands.
once :: Eq a => [a] -> [a]
once = concatMap (take 1) . group

-- | What the guard lets through of it: velocities within limits, each once.
through :: [Action] -> [Action]
through as = once (map limited (filter isVelocity as)) ++ filter (not . isVelocity) as
  where
    limited a = case a of
      VelocityCommand (Velocity v w) -> VelocityCommand (uncurry Velocity (withinWheels (Wheels 0.7 0.23) (max (-0.7) (min 0.7 v), max (negate pi) (min pi w))))
      _ -> a

-- ---------------------------------------------------------------------------------------------
-- The links

inPlace :: (String, IO ()) -> Assertion
inPlace (name, main') = do
  expected <- reference main'
  told <- newTVarIO []
  wishes <- newTVarIO []
  begun <- newTVarIO 0
  released <- newTVarIO 0
  hearing' <- newEventQueue
  stop <- newTVarIO False
  guarded <- newTVarIO (newGuard (Limits 0.7 pi (Just (Wheels 0.7 0.23))) False)
  let base = Connection (verbatim "a robot") [] (const (pure [])) (\_ a -> atomically (modifyTVar' told (a :))) (pure ()) (\_ _ -> pure ()) (awaitEvents hearing') (unreadableSoFar hearing') (pure Nothing)
      observer = (onTerminal (verbatim "a robot")) {onProgramCommand = \a -> atomically (modifyTVar' wishes (a :)), onNotice = const (pure ())}
      pace =
        Pace
          { newSeed = pure 1,
            timeOfDay = pure 0,
            timeNow = timeOf . subtract 1 <$> readTVarIO begun,
            awaitStep = atomically (modifyTVar' begun (+ 1)) >> atomically ((>=) <$> readTVar released <*> readTVar begun >>= check),
            stepTimeout = 120
          }
      -- The step before is over when this one waits to begin; a run may be over before.
      step running n act = do
        awaiting (atomically ((readTVar begun >>= check . (== n)) `orElse` void (waitSTM running)))
        atomically (act >> writeTVar released n)
      hears' = mapM_ (enqueue hearing' . Received)
      steps = starting (map snd recorded)
  withProgramAtPipe noMailbox main' $ \socket -> do
    -- What happens before the program starts is not for it, on any channel.
    atomically (hears' stale >> enqueue hearing' Connected >> hears' stale >> mapM_ hears' (take 1 steps))
    withAsync (runLockstep pace observer (readTVar stop) Nothing 10 guarded base socket) $ \running -> do
      step running 1 (pure ())
      forM_ (zip [2 ..] (drop 1 steps)) $ \(n, ms) -> step running n (hears' ms)
      step running (length steps + 1) (writeTVar stop True)
      awaiting (void (wait running))
  readTVarIO wishes >>= \as -> sameAs name (reverse as) expected
  readTVarIO told >>= \as -> sameAs name (through (reverse as)) (through expected)

-- | Events of before a program's start, of the robot and of topics of the program's own.
stale :: [Message]
stale = [BumperMessage (Bumper side Pressed) | side <- [minBound ..]] ++ [ButtonMessage (Button Button1 Pressed), CliffMessage (Cliff LeftCliff Hole), WheelMessage (Wheel LeftWheel Air), OpenMessage "/own" (Aeson.object [])]

-- | The robot's address, with nothing between the program and the wheels but the limits.
reached :: Rig -> (Connection -> IO a) -> IO a
reached r use = either (assertFailure . T.unpack . english . explainTargetError) pure (readTarget (url r ++ "?safety=off" ++ options r)) >>= (`withConnection` use)

-- | A robot that speaks JSON: the programs for which it has the parts, its line for a message, and the commands in what it was told.
data JsonRobot = JsonRobot
  { programs :: [(String, IO ())],
    sends :: Message -> Maybe String,
    toldBy :: [String] -> [Action]
  }

kobuki :: String -> JsonRobot
kobuki prefix' = JsonRobot plays (Just . messageTo prefix') (mapMaybe (commandOf prefix'))

-- | A Create 3, by the definitions of its messages.
create3 :: JsonRobot
create3 = JsonRobot (filter ((`elem` paper) . fst) plays) sent (concatMap ros2Command)
  where
    sent m = case m of
      OdometryMessage o -> Just ("send /odom " ++ odometryJson o)
      BumperMessage (Bumper side s) -> hazard 1 (case side of LeftBumper -> "bump_left"; CenterBumper -> "bump_front_center"; RightBumper -> "bump_front_right") (s == Pressed)
      CliffMessage (Cliff side s) -> hazard 2 (case side of LeftCliff -> "cliff_side_left"; CenterCliff -> "cliff_front_left"; RightCliff -> "cliff_side_right") (s == Hole)
      WheelMessage (Wheel side s) -> hazard 4 (case side of LeftWheel -> "left_wheel"; RightWheel -> "right_wheel") (s == Air)
      ButtonMessage (Button n s) -> Just (unwords ["button", case n of Button0 -> "button_1"; Button1 -> "button_power"; Button2 -> "button_2", switch (s == Pressed)])
      _ -> Nothing
    hazard kind frame on = Just (unwords ["hazard", show (kind :: Int), frame, switch on])
    switch on = if on then "on" else "off"

turtlebot3 :: JsonRobot
turtlebot3 = JsonRobot (filter ((`elem` ["accelerate", "drawSquare"]) . fst) plays) sent (concatMap ros2Command)
  where
    sent m = case m of
      OdometryMessage o -> Just ("send /odom " ++ odometryJson o)
      _ -> Nothing

-- | The programs of the paper.
paper :: [String]
paper = ["accelerate", "accelerateAndPlay", "forwardBackward", "safetyControl", "mux", "randomWalk", "safeRandomWalk", "drawSquare"]

-- | The commands in a line of a ROS 2 robot. The light ring says what both lights are.
ros2Command :: String -> [Action]
ros2Command line = case break (== ' ') <$> stripPrefix "got " line of
  Just (topic, text) | Just (Object o) <- Aeson.decode (LC.pack text) -> case topic of
    "/cmd_vel" -> fold' (\m -> [VelocityCommand (Velocity v w) | (v, w) <- fold' pure (parseMaybe twist m)]) (parseMaybe (\m -> m .: "twist" <|> pure m) o)
    "/cmd_lightring" -> fold' (\ls -> [Led1Command (Led1 (color (ls !! 3))), Led2Command (Led2 (color (ls !! 1)))]) (parseMaybe (.: "leds") o)
    "/cmd_audio" -> fold' (\notes -> [SoundCommand (melody (map (.: "frequency") notes))]) (parseMaybe (.: "notes") o)
    "/rosy/say" -> fold' (\s -> [SayCommand (Say s)]) (parseMaybe (.: "data") o)
    _ -> []
  _ -> []
  where
    fold' = maybe []
    twist m = (,) <$> (m .: "linear" >>= (.: "x")) <*> (m .: "angular" >>= (.: "z"))
    color led = case parseMaybe (\l -> (,) <$> l .: "red" <*> l .: "green") led :: Maybe (Int, Int) of
      Just (255, 0) -> Red
      Just (255, _) -> Orange
      Just (0, 255) -> Green
      _ -> Black
    -- By its first note and their number.
    melody notes = case (length notes, mapMaybe (parseMaybe id) (take 1 notes) :: [Int]) of
      (3, [523]) -> OnSound
      (3, _) -> OffSound
      (1, _) -> ButtonSound
      (2, _) -> ErrorSound
      (_, [440]) -> RechargeSound
      (_, [392]) -> CleaningStartSound
      _ -> CleaningEndSound

-- | Messages go in as JSON, and commands come out so. All programs drive over one connection.
jsonRobot :: JsonRobot -> Rig -> IO ()
jsonRobot kind r = do
  expected <- mapM (reference . snd) (programs kind)
  prepared r
  reached r $ \base -> forM_ (zip3 (programs kind) expected (False : repeat True)) $ \((name, main'), e, known) -> do
    before <- length <$> transcript (robot r)
    got <- concat <$> playing main' base known (\hands -> unless known (attached r) >> stream hands)
    sameAs name got e
    let told ls = withoutStops (seen isVelocity got) (toldBy kind (drop before ls))
    awaitTranscript (robot r) (\ls -> all (\(_, is) -> seen is (told ls) == seen is got) channels)
    transcript (robot r) >>= \ls -> sameAs (name ++ ", told") (concatMap (\(_, is) -> seen is (told ls)) channels) (concatMap (\(_, is) -> seen is got) channels)
  where
    -- A link that is told nothing new for 0.6 s, as on a busy machine, says stop by itself, and goes on after that.
    withoutStops = go Nothing
    go before wanted' told' = case told' of
      [] -> []
      t : ts
        | not (isVelocity t) -> t : go before wanted' ts
        | w : ws <- wanted', near w t -> t : go (Just t) ws ts
        | near (VelocityCommand (Velocity 0 0)) t || maybe False (near t) before -> go before wanted' ts
        | otherwise -> t : go before wanted' ts
    -- Each topic travels by itself, so a message is answered before the next is sent, which could overtake it.
    stream hands = forM_ (zip [0 ..] (map snd recorded)) $ \(n, ms) -> do
      ended <- isOver hands
      unless ended $ do
        at hands n
        forM_ (mapMaybe (sends kind) (ms ++ [RobotStatusMessage Online | n == 0])) $ \line -> say (robot r) line >> answers hands 1
        when (ticksAt n) (tick hands)
    -- A light that is told to be what it is may be told again with the other one.
    seen is as = (if any isLight chosen then once . (dark chosen ++) else id) chosen
      where
        chosen = filter is (through as)
    dark chosen = take 1 [a | Action c _ <- take 1 chosen, a <- [Action c [Whole 0]]]
    isLight a = case a of
      Led1Command _ -> True
      Led2Command _ -> True
      _ -> False

-- | The command in a line of a robot whose topics have this prefix.
commandOf :: String -> String -> Maybe Action
commandOf prefix' line = do
  (topic, text) <- break (== ' ') <$> (stripPrefix ("got " ++ prefix' ++ "/commands/") line `orIf` stripPrefix "got /rosy/" line)
  Object o <- Aeson.decode (LC.pack text)
  case topic of
    "velocity" -> parseMaybe (\m -> fmap VelocityCommand (Velocity <$> (m .: "linear" >>= (.: "x")) <*> (m .: "angular" >>= (.: "z")))) o
    "led1" -> Led1Command . Led1 . toEnum <$> parseMaybe (.: "value") o
    "led2" -> Led2Command . Led2 . toEnum <$> parseMaybe (.: "value") o
    "sound" -> SoundCommand . toEnum <$> parseMaybe (.: "value") o
    "say" -> SayCommand . Say <$> parseMaybe (.: "data") o
    _ -> Nothing
  where
    orIf a b = if isJust a then a else b

-- | The line that makes such a robot send a message.
messageTo :: String -> Message -> String
messageTo prefix' m = case m of
  OdometryMessage o -> "send /odom " ++ odometryJson o
  BumperMessage (Bumper n s) -> event "bumper" [("bumper", fromEnum n), ("state", fromEnum (s == Pressed))]
  CliffMessage (Cliff n s) -> event "cliff" [("sensor", fromEnum n), ("state", fromEnum (s == Hole)), ("bottom", 0)]
  WheelMessage (Wheel n s) -> event "wheel_drop" [("wheel", fromEnum n), ("state", fromEnum (s == Air))]
  ButtonMessage (Button n s) -> event "button" [("button", fromEnum n), ("state", fromEnum (s == Pressed))]
  RobotStatusMessage s -> event "robot_state" [("state", fromEnum (s == Online))]
  _ -> error ("nothing to send for " ++ show m)
  where
    event topic fields = "send " ++ prefix' ++ "/events/" ++ topic ++ " {" ++ intercalate ", " [show (k :: String) ++ ": " ++ show v | (k, v) <- fields] ++ "}"

-- | Packets go in, and the wheels' speeds come out as the base encodes them. It is plugged in anew for each program.
serialRobot :: Rig -> IO ()
serialRobot r = do
  expected <- mapM (reference . snd) plays
  prepared r
  forM_ (zip plays expected) $ \((name, main'), e) -> do
    mapM_ (say (robot r)) ["unplug", "plug"]
    _ <- hears (robot r) "plugged"
    before <- length <$> transcript (robot r)
    let agrees batches ls = and [fits k (heardAs k (drop before ls)) (toldAs k batches) | k <- ["control", "led1", "led2", "sound"]]
        -- One packet carries one speed: it has arrived before the next message comes.
        settled batches = do
          ls <- transcript (robot r)
          unless (agrees batches ls) $ do
            say (robot r) "nudge"
            awaitTranscript (robot r) (agrees batches)
            transcript (robot r) >>= agreed batches
        agreed batches ls = forM_ ["control", "led1", "led2", "sound"] $ \k ->
          assertBool (unlines [name, k, "told: " ++ show (toldAs k batches), "heard: " ++ show (heardAs k (drop before ls))]) (fits k (heardAs k (drop before ls)) (toldAs k batches))
        stream hands = forM_ (zip [0 ..] recorded) $ \(n, (bytes, ms)) -> do
          ended <- isOver hands
          unless ended $ do
            at hands n
            say (robot r) ("replay " ++ hexadecimal bytes)
            answers hands (length ms + fromEnum (n == 0))
            soFar hands >>= settled
            when (ticksAt n) (tick hands >> soFar hands >>= settled)
    got <- reached r $ \base -> playing main' base False (\hands -> attached r >> stream hands) >>= \got -> got <$ settled got
    sameAs name (concat got) e
    transcript (robot r) >>= agreed got

hexadecimal :: B.ByteString -> String
hexadecimal = LC.unpack . Builder.toLazyByteString . Builder.byteStringHex

-- | What the base says that it was told: speed and radius are the last words.
heardAs :: String -> [String] -> [String]
heardAs kind ls = [unwords (if kind == "control" then drop 2 rest else rest) | k : rest <- map words ls, k == kind]

-- | What it is told, by message or tick. Only the last of a batch is sure to arrive: a packet carries what is wanted when it is written.
data Told = Optional String | Required String
  deriving (Show)

toldAs :: String -> [[Action]] -> [Told]
toldAs kind batches = case kind of
  "control" -> inBatches (\case VelocityCommand (Velocity v w) -> Just (control v w); _ -> Nothing)
  "led1" -> Required "0" : inBatches (\case Led1Command (Led1 c) -> Just (light c); _ -> Nothing)
  "led2" -> Required "0" : inBatches (\case Led2Command (Led2 c) -> Just (light c); _ -> Nothing)
  _ -> [Required (show (fromEnum sound)) | SoundCommand sound <- concat batches]
  where
    inBatches f = concatMap (lastRequired . mapMaybe f . through) batches
    lastRequired values = [(if n == length values then Required else Optional) value | (n, value) <- zip [1 ..] values]
    control v w = let (speed, radius) = uncurry wheelCommand (withinWheels (Wheels 0.7 0.23) (v, w)) in unwords [show speed, show radius]
    light c = show (case c of Black -> 0 :: Int; Red -> 1; Green -> 2; Orange -> 3)

-- | Whether the base heard what it was told. Lights and speeds are heard when they change; every sound is. On a busy machine the link itself says
-- stop, because it was told nothing new for 0.6 s, and goes on after that.
fits :: String -> [String] -> [Told] -> Bool
fits kind heard told
  | kind == "sound" = heard == [value | Required value <- told]
  | otherwise = go "" (if kind == "control" then "0 0" else "") heard told
  where
    -- What was told last, and what the base does. A stop may be the program's or the link's: what follows tells.
    go before now heard' told' =
      (null heard' && null told')
        || case told' of
          Optional t : ts -> go t now heard' ts || comes t heard' ts
          Required t : ts -> (t == now && go t now heard' ts) || comes t heard' ts
          [] -> False
        || case heard' of
          h : hs | h `elem` ["0 0", before], h /= now -> go before h hs told'
          _ -> False
    comes t heard' ts = case heard' of
      h : hs -> h == t && go t h hs ts
      [] -> False
