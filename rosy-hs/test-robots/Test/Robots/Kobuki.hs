-- |
-- Description : The serial protocol, byte by byte.
module Test.Robots.Kobuki (tests, corePacket, senseCore, anHour) where

import Data.Bits (shiftR, xor, (.&.))
import qualified Data.ByteString as B
import Data.Foldable (fold)
import Data.List (foldl')
import Data.Word (Word16, Word8)
import Numeric (readHex)
import Rosy.Channel (Channel (..), Kind (..), Message (..), tellMessage)
import Rosy.Kobuki.Command
import Rosy.Kobuki.Feedback
import Rosy.Kobuki.Frame
import Rosy.Kobuki.Sensing
import Rosy.Robot
import Rosy.Robots.Connection (RobotEvent (..))
import Rosy.Robots.Guard
import Rosy.Robots.SerialCodec (readParts)
import System.Random (mkStdGen, randomR)
import Test.Tasty
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck hiding (again, (.&.))

tests :: TestTree
tests = testGroup "the serial protocol" [commands, framing, feedback, sensing]

commands :: TestTree
commands =
  testGroup
    "commands are these bytes"
    [ testGroup
        "speeds"
        [ golden "0.1 m/s" (baseControl 0.1 0) "AA 55 06 01 04 64 00 00 00 67",
          golden "-0.1 m/s" (baseControl (-0.1) 0) "AA 55 06 01 04 9C FF 00 00 60",
          golden "0.5 rad/s" (baseControl 0 0.5) "AA 55 06 01 04 39 00 01 00 3B",
          golden "0.1 m/s, 0.5 rad/s" (baseControl 0.1 0.5) "AA 55 06 01 04 9D 00 C8 00 56",
          golden "0.1 m/s, -0.5 rad/s" (baseControl 0.1 (-0.5)) "AA 55 06 01 04 9D 00 38 FF 59",
          golden "-0.1 m/s, -0.4 rad/s" (baseControl (-0.1) (-0.4)) "AA 55 06 01 04 6E FF FA 00 68",
          -- The outer wheel's speed and the radius, where the driver's formulas change.
          testCase "the limits: 0.7 m/s and half a turn a second" $
            map (uncurry wheelCommand) [(0.7, 0), (-0.7, 0), (0, pi), (0, -pi), (0.7, pi)] @?= [(700, 0), (-700, 0), (361, 1), (-361, 1), (1061, 222)],
          testCase "so little of a turn that it is none, so little speed that it turns on the spot, a radius of a millimetre" $
            map (uncurry wheelCommand) [(0.5, 0.00009), (0.00009, 0.5), (0.0005, 0.5)] @?= [(500, 0), (57, 1), (57, 1)],
          testCase "a radius beyond 16 bits is the largest there is, as in the driver" $
            map (uncurry wheelCommand) [(0.5, 0.001), (0.5, -0.001), (40, 0)] @?= [(500, 32767), (500, -32768), (32767, 0)]
        ],
      golden "LED 1 orange, power on" (outputs (obeying (Led1Command (Led1 Orange)) powerOn)) "AA 55 04 0C 02 F0 03 F9",
      golden "the sound of a button" (fold (ownPacket (SoundCommand ButtonSound))) "AA 55 03 04 01 03 05",
      golden "which versions are you" requestVersions "AA 55 04 09 02 0B 00 04",
      testCase "one power connector is switched off, and on again" $ do
        let off = obeying (ExternalPowerCommand (ExternalPower Power12V5A PowerOff)) powerOn
        outputs off @?= packet (B.pack [12, 2, 0xB0, 0])
        obeying (ExternalPowerCommand (ExternalPower Power12V5A PowerOn)) off @?= powerOn,
      testCase "lights do not disturb each other or the power" $
        outputs (obeying (Led2Command (Led2 Green)) (obeying (Led1Command (Led1 Red)) (obeying (Led2Command (Led2 Orange)) powerOn))) @?= packet (B.pack [12, 2, 0xF0, 0x09]),
      testProperty "speeds are within 16 bits, whatever was asked for" $ \v w ->
        let (s, r) = wheelCommand v w in s >= minBound && r <= maxBound,
      testProperty "the base does what was asked for, to a millimetre" $
        forAll ((,) <$> choose (-0.7, 0.7) <*> choose (-3, 3)) $ \(v, w) ->
          abs w < 0.05 || abs v < 0.001 || abs (v / w) < 0.002 || near (did (wheelCommand v w)) (v, w)
    ]
  where
    golden name bytes expected = testCase name $ bytes @?= B.pack (map (fst . head' . readHex) (words expected))
    head' xs = case xs of x : _ -> x; [] -> (0, "")
    -- The inverse that the emulator of upstream's test uses.
    did (s, r)
      | r == 0 = (fromIntegral s / 1000, 0)
      | abs r == 1 = (0, fromIntegral s / 115)
      | otherwise = let w = fromIntegral s / (fromIntegral r + signum (fromIntegral r) * 115) in (fromIntegral r * w / 1000, w)
    near (a, b) (c, d) = abs (a - c) < 0.01 && abs (b - d) < 0.1 + abs d * 0.05 :: Bool

framing :: TestTree
framing =
  testGroup
    "packets"
    [ testProperty "are found wherever the bytes are cut" $
        forAll (listOf payload) $ \ps cuts ->
          let stream = B.concat (map packet ps)
           in feedAll (cutAt cuts stream) === ps,
      testProperty "are found behind noise that is no packet" $
        forAll ((,) <$> payload <*> noise) $ \(p, n) ->
          feedAll [n, packet p] === [p],
      testProperty "with one byte changed are not taken" $
        forAll payload $ \p i (Positive change) ->
          let bytes = packet p
              at = 3 + i `mod` (B.length bytes - 3)
              spoilt = B.take at bytes <> B.singleton (B.index bytes at `xor` (fromIntegral (change :: Int) .&. 0x7F)) <> B.drop (at + 1) bytes
           in change .&. 0x7F == 0 || p `notElem` feedAll [spoilt],
      testProperty "never hold back more than one packet" $ \bytes ->
        let Feeding _ _ rest = feed noBytes (B.pack bytes)
         in length (show rest) < 5 * (maxPayload + 20)
    ]
  where
    -- Payloads that hold no head of a packet, so that the expected answer is simple.
    payload = B.pack . map (\b -> if b == 0xAA then 0xAB else b) <$> (choose (3, 80) >>= vector)
    noise = B.pack . map (\b -> if b == 0xAA then 0x55 else b) <$> arbitrary

feedAll :: [B.ByteString] -> [B.ByteString]
feedAll = snd . foldl' (\(s, seen) b -> let Feeding ps _ s' = feed s b in (s', seen ++ ps)) (noBytes, [])

cutAt :: [Int] -> B.ByteString -> [B.ByteString]
cutAt cuts b = case cuts of
  [] -> [b]
  c : cs | B.null b -> [] | otherwise -> let (x, y) = B.splitAt (c `mod` (B.length b + 1)) b in x : cutAt cs y

feedback :: TestTree
feedback =
  testGroup
    "feedback"
    [ testCase "core sensors, gyroscope, versions and serial number are read; unknown parts are skipped" $
        readFeedback (readParts (B.concat [B.pack [99, 2, 1, 2], corePart 1000 4 2 1 7 8 2, B.pack [4, 7, 0x9C, 0xFF, 10, 0, 0, 0, 0], B.pack [11, 4, 4, 1, 1, 0], B.pack [19, 12, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0]]))
          @?= [Other 99, CoreSensors (Core 1000 4 2 1 7 8 2), InertiaSensor (Inertia (-100) 10), Firmware (Version 1 1 4), Udid 1 2 3],
      testCase "a part that is cut off is left out" $
        readFeedback (readParts (B.pack [1, 15, 0, 0])) @?= [],
      testProperty "any bytes are read" $ \bytes -> all (\f -> f == f) (readFeedback (readParts (B.pack bytes)))
    ]

-- | Time stamp, bumpers, wheel drops, cliffs, encoders, buttons.
corePart :: Word16 -> Word8 -> Word8 -> Word8 -> Word16 -> Word16 -> Word8 -> B.ByteString
corePart t b d c l r n = B.pack ([1, 15] ++ u16 t ++ [b, d, c] ++ u16 l ++ u16 r ++ [0, 0, n, 0, 160, 0])
  where
    u16 x = [fromIntegral (x .&. 255), fromIntegral (x `shiftR` 8)]

-- | A whole packet.
corePacket :: Core -> Inertia -> B.ByteString
corePacket core i = packet (corePart' core <> inertiaPart i)

corePart' :: Core -> B.ByteString
corePart' (Core t b d c l r n) = corePart t b d c l r n

inertiaPart :: Inertia -> B.ByteString
inertiaPart (Inertia a rate) = B.pack ([4, 7] ++ i16 a ++ i16 rate ++ [0, 0, 0])
  where
    i16 x = let w = fromIntegral x :: Word16 in [fromIntegral (w .&. 255), fromIntegral (w `shiftR` 8)]

-- | Takes a packet with these parts.
senseCore :: Core -> Maybe Inertia -> Sensing -> ([Message], Sensing)
senseCore core i = sense (readParts (corePart' core <> foldMap inertiaPart i))

sensing :: TestTree
sensing =
  testGroup
    "sensing"
    [ testCase "a bit that changes is an event, in the base's order; a bit that stays is none" $ do
        let (first, s1) = senseCore (still 20) {bumpers = 5, wheelDrops = 1, buttons = 2, cliffs = 4} Nothing unsensed
            (again, s2) = senseCore (still 40) {bumpers = 5, wheelDrops = 1, buttons = 2, cliffs = 4} Nothing s1
            (later, _) = senseCore (still 60) Nothing s2
        events first
          @?= [ ButtonMessage (Button Button1 Pressed),
                BumperMessage (Bumper LeftBumper Pressed),
                BumperMessage (Bumper RightBumper Pressed),
                CliffMessage (Cliff LeftCliff Hole),
                WheelMessage (Wheel RightWheel Air)
              ]
        events again @?= []
        map tellMessage (events later) @?= map (swap . tellMessage) (events first),
      testCase "battery, charger, dock, gyroscope and inputs are told when they change, by the robot's description" $ do
        let payload t = corePart t 0 0 0 0 0 0 <> inertiaPart (Inertia 0 18000) <> B.pack ([3, 3, 2, 0, 1] ++ [16, 16, 5, 0, 0xFF, 0x0F] ++ replicate 12 0)
            (first, s1) = sense (readParts (payload 20)) unsensed
            (again, _) = sense (readParts (payload 40)) s1
            other m = case m of OdometryMessage _ -> False; TurnRateMessage _ -> False; _ -> True
        [r | TurnRateMessage (TurnRate r) <- first] `nearly` [pi]
        map tellMessage (filter other first)
          @?= ["Battery 16.0", "Discharging", "DockInfraRed NearLeft NoSignal NearCenter", "DigitalInput True False True False", "AnalogInput 3.3 0.0 0.0 0.0"]
        length again @?= 1,
      testCase "counters and time stamps that wrap move the robot on" $ do
        let path = [Core (fromIntegral (65500 + 20 * i :: Int)) 0 0 0 (at i) (at i) 0 | i <- [0 .. 10]]
            at i = fromIntegral (65400 + 100 * i :: Int)
            odometry = odometries (run [(c, Just (Inertia 0 0)) | c <- path])
        map odometryVelocity (take 1 odometry) @?= [Velocity 0 0]
        let Position x y = odometryPosition (last odometry)
        assertBool (show x) (abs (x - 1000 * metresPerTick) < 1e-9 && y == 0)
        assertBool "0.1 m/s per 23.45 ticks" (all (\o -> abs (velocityLinear (odometryVelocity o) - 100 * metresPerTick / 0.02) < 1e-9) (drop 1 odometry)),
      testCase "the heading is the gyroscope's, from where it was first, across the wrap" $ do
        let turnTo a = (still (fromIntegral (20 * a)), Just (Inertia (fromIntegral ((17900 + 100 * a + 18000) `mod` 36000 - 18000)) 5000))
            odometry = odometries (run (map turnTo [0 .. 5 :: Int]))
        assertBool (show (map odometryOrientation odometry)) (and (zipWith (\i o -> abs (angleOf o - fromIntegral i * pi / 180) < 1e-9) [0 :: Int ..] odometry)),
      testCase "what no robot can do is not believed once, but when it goes on" $ do
        let (_, s1) = senseCore (still 20) Nothing unsensed
            far t = (still t) {leftEncoder = 20000, rightEncoder = 20000}
            outcomes = drop 1 (scanl (\(_, s) t -> senseCore (far t) Nothing s) ([], s1) [40, 60 ..])
        map (length . fst) (take 7 outcomes) @?= [0, 0, 0, 0, 0, 1, 1]
        map (odometryPosition . snd') (concatMap fst (take 7 outcomes)) @?= [Position 0 0, Position 0 0],
      testCase "an hour of packets of which one in a hundred is spoilt gives no event that was not there, no leap, and no command but the program's" $
        anHour 7 @?= 0
    ]
  where
    nearly found expected = assertBool (show found) (length found == length expected && and (zipWith (\a b -> abs (a - b) < 1e-9) found expected))
    still t = Core t 0 0 0 0 0 0
    events = filter (\(Message c _) -> channelKind c == EventChannel)
    snd' m = case m of OdometryMessage o -> o; _ -> Odometry (Position 9 9) (Orientation 9) (Velocity 9 9)
    odometries ms = [o | OdometryMessage o <- ms]
    run = concat . fst . foldl' (\(seen, s) (c, i) -> let (ms, s') = senseCore c i s in (seen ++ [ms], s')) ([], unsensed)
    angleOf o = let Orientation a = odometryOrientation o in a
    swap s = unwords (map (\w -> case w of "Pressed" -> "Released"; "Hole" -> "Floor"; "Air" -> "Ground"; _ -> w) (words s))

-- | Events, leaps and commands that should not have been, in an hour of packets of which one in a hundred is spoilt by this chance.
anHour :: Int -> Int
anHour seed = wrongs
  where
    (wrongs, _, _, _, _) = foldl' step (0 :: Int, noBytes, unsensed, snd (onEvent Connected (newGuard (Limits 0.7 pi Nothing) True)), mkStdGen seed) [0 .. 180000 - 1 :: Int]
    still t = Core t 0 0 0 0 0 0
    events = filter (\(Message c _) -> channelKind c == EventChannel)
    -- The robot stands still, so every event is a wrong one; the program wants one speed ten times a second, so the safety rules have
    -- nothing to say, and every other speed is a wrong one.
    step (wrong, frames, s, guard', g) i =
      let bytes = corePacket (still (fromIntegral (20 * i))) (Inertia 0 0)
          (spoilt, g1) = randomR (1, 100 :: Int) g
          (sent, g2) = if spoilt == 1 then spoil bytes g1 else (bytes, g1)
          Feeding found _ frames' = feed frames sent
          (messages, s') = foldl' (\(ms, st) p -> let (m, st') = sense (readParts p) st in (ms ++ m, st')) ([], s) found
          heard' = foldl' (\gd m -> snd (onEvent (Received m) gd)) guard' messages
          (told, guard2)
            | i `mod` 5 /= 0 = ([], heard')
            | otherwise =
              let at' = fromIntegral i / 50
                  (as, gd) = onCommand at' wanted heard'
                  (bs, gd') = onTick at' gd
               in (as ++ bs, gd')
          bad = length (filter (/= wanted) told) + length [() | i `mod` 5 == 0, length told /= 2] + length (events messages) + length [() | OdometryMessage (Odometry (Position x _) _ _) <- messages, abs x > 0.03]
       in bad `seq` guard2 `seq` (wrong + bad, frames', s', guard2, g2)
    wanted = VelocityCommand (Velocity 0.2 0)
    -- Up to four bytes changed, or the end missing, or bytes in between.
    spoil bytes g =
      let (how, g1) = randomR (0, 5 :: Int) g
          (at, g2) = randomR (0, B.length bytes - 1) g1
          (by, g3) = randomR (1, 255 :: Int) g2
          change (b, gen) _ =
            let (i, gen1) = randomR (0, B.length b - 1) gen
                (x, gen2) = randomR (1, 255 :: Int) gen1
             in (B.take i b <> B.singleton (B.index b i `xor` fromIntegral x) <> B.drop (i + 1) b, gen2)
       in case how of
            0 -> (B.take at bytes, g3)
            1 -> (B.take at bytes <> B.singleton (fromIntegral by) <> B.drop at bytes, g3)
            n -> foldl' change (bytes, g3) [1 .. n - 1]
