{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : Guard of real robots: limits, repetition, safety rules, odometry.
module Test.Robots.Guard (tests) where

import Control.Applicative ((<|>))
import Control.Monad ((>=>))
import Data.Aeson (Object, (.:), (.:?))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (Parser, parseEither)
import qualified Data.ByteString.Char8 as C
import Data.Foldable (toList)
import Data.List (mapAccumL, nub)
import Rosy.Channel (Action)
import Rosy.Robot
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.Target (readTarget, targetLimits)
import Rosy.Sentence (verbatim)
import Test.Tasty
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

-- | What can happen to a guard, a tenth of a second apart.
data Happening = Says RobotEvent | Wants Action | Ticks | Halts | Watched Bool | Renewed | Armed | Away | Switched Bool
  deriving (Show)

tests :: TestTree
tests =
  testGroup
    "the guard"
    [ testCase "repeats a velocity that is not zero, and zero only once" $
        told False [Wants (VelocityCommand (Velocity 0.2 0)), Ticks, Ticks, Wants (VelocityCommand (Velocity 0 0)), Ticks]
          @?= [[VelocityCommand (Velocity 0.2 0)], [VelocityCommand (Velocity 0.2 0)], [VelocityCommand (Velocity 0.2 0)], [VelocityCommand (Velocity 0 0)], []],
      testCase "tells a robot that is lost to stand, and forgets its velocity" $
        told False [Wants (VelocityCommand (Velocity 0.2 0)), Says (Disconnected (verbatim "away")), Ticks, Wants (VelocityCommand (Velocity 0.3 0)), Says Connected, Ticks]
          @?= [[VelocityCommand (Velocity 0.2 0)], [VelocityCommand (Velocity 0 0)], [], [], [], []],
      testCase "keeps a robot that was lost standing until it is armed, whatever the program and the safety rules want" $
        told True [Says (Disconnected (verbatim "away")), Says Connected, drive, Ticks, bump CenterBumper Pressed, Ticks, bump CenterBumper Released, Armed, Ticks, drive]
          @?= [[VelocityCommand (Velocity 0 0)], [], [], [], [], [], [], [], [], [VelocityCommand (Velocity 0.2 0)]],
      testCase "lets a robot that was lost drive on by itself where its address says so" $
        fst (onCommand 0 (VelocityCommand (Velocity 0.2 0)) (foldl (\g h -> snd (onEvent h g)) (withoutRearming (newGuard limits' False)) [Connected, Disconnected (verbatim "away"), Connected]))
          @?= [VelocityCommand (Velocity 0.2 0)],
      testProperty "after an absence that is too long nothing but zero reaches the wheels until a person agrees or a new run begins" $ \(Positive extra) happenings ->
        let before = zip [0, 0.1 ..] [drive, Ticks]
            since = 0.1 + longestAbsence + extra
            still = map fromSeed (happenings :: [(Int, Double, Double)])
            later = zip [since, since + 0.1 ..] (still ++ [drive, Ticks])
            agreed = zip [last (map fst later) + x | x <- [0.1, 0.2]] [Armed, drive]
            all' = toldAt limits' False (before ++ later ++ agreed)
            (absent, there) = splitAt (length later) (drop (length before) all')
         in counterexample (show all') (nub (concat absent) === [VelocityCommand (Velocity 0 0)] .&&. last there === [VelocityCommand (Velocity 0.2 0)]),
      testCase "the longest absence that does not count" $
        toldAt limits' False [(0, drive), (longestAbsence, Ticks)] @?= [[VelocityCommand (Velocity 0.2 0)], [VelocityCommand (Velocity 0.2 0)]],
      testCase "what was queued in an absence does not reach the program as new, but for states and the robot's status" $ do
        let press = BumperMessage (Bumper CenterBumper Pressed)
            states = [OdometryMessage (Odometry (Position 0 0) (Orientation 0) (Velocity 0 0)), RobotStatusMessage Offline]
            arriving = press : states
            heardAt g0 times = snd (mapAccumL (\g t -> let ((ms, _), g') = freshMessages t arriving g in (g', ms)) g0 times)
            again = 0.1 + longestAbsence + 0.1
            before make = snd (onEvent Connected (make (newGuard limits' False)))
            fresh = replicate 5 arriving
        -- The longest that does not count; then one that does, and what the system had queued arrives a little later.
        heardAt (before id) [0, 0.1, 0.1 + longestAbsence] @?= take 3 fresh
        heardAt (before id) [0, 0.1, again, again + 0.02, again + longestAbsence] @?= [arriving, arriving, states, states, arriving]
        heardAt (before withoutRearming) [0, 0.1, again, again + 0.02, again + longestAbsence] @?= fresh,
      testCase "an absence that a step begins with stops the robot" $
        snd (fst (freshMessages 1 [] (snd (onTick 0 (snd (onEvent Connected (newGuard limits' False))))))) @?= [VelocityCommand (Velocity 0 0)],
      testCase "a person agrees to an owner that was away" $
        told False [drive, Away, Ticks, drive, Armed, drive] @?= [[VelocityCommand (Velocity 0.2 0)], [], [], [], [], [VelocityCommand (Velocity 0.2 0)]],
      testCase "lets a new run drive a robot that was lost before" $
        told False [Says (Disconnected (verbatim "away")), Says Connected, Renewed, drive] @?= [[VelocityCommand (Velocity 0 0)], [], [], [VelocityCommand (Velocity 0.2 0)]],
      testCase "tells a robot that is refused to stand" $
        told False [drive, Says (Refused (verbatim "old")), Ticks] @?= [[VelocityCommand (Velocity 0.2 0)], [VelocityCommand (Velocity 0 0)], []],
      testProperty "a safety manoeuvre is never followed by zero while the program drives" $ \touches ->
        let touch (n, on) = [bump (toEnum (n `mod` 3)) (if on then Pressed else Released), drive, Ticks]
            happenings = drive : concatMap touch (touches :: [(Int, Bool)]) ++ [Ticks, Ticks, Ticks]
         in VelocityCommand (Velocity 0 0) `notElem` concat (told True happenings),
      testCase "tells the program that the robot is lost, once" $
        fst (onEvent (Disconnected (verbatim "x")) (snd (onEvent (Disconnected (verbatim "x")) (snd (onEvent Connected (newGuard limits' False)))))) @?= ([], []),
      testCase "lets nothing move after a halt" $
        told False [Wants (VelocityCommand (Velocity 0.2 0)), Halts, Ticks, Wants (VelocityCommand (Velocity 0.2 0)), Wants (Led1Command (Led1 Red))]
          @?= [[VelocityCommand (Velocity 0.2 0)], [VelocityCommand (Velocity 0 0)], [], [], [Led1Command (Led1 Red)]],
      testCase "stands while it is not watched, and goes on when it is" $
        told False [Wants (VelocityCommand (Velocity 0.2 0)), Watched True, Watched False, Watched False, Ticks, Wants (VelocityCommand (Velocity 0.3 0)), Watched True, Ticks]
          @?= [[VelocityCommand (Velocity 0.2 0)], [], [VelocityCommand (Velocity 0 0)], [], [], [], [], [VelocityCommand (Velocity 0.3 0)]],
      testCase "does not back off while it is not watched" $
        told True [Watched False, bump LeftBumper Pressed, Ticks, Watched True, Ticks] @?= [[VelocityCommand (Velocity 0 0)], [], [], [], [back (-0.4)]],
      testCase "begins anew after a halt, with nothing left of the velocity and all of what is pressed" $
        told True [Wants (VelocityCommand (Velocity 0.2 0)), Halts, bump CenterBumper Pressed, Renewed, Ticks] @?= [[VelocityCommand (Velocity 0.2 0)], [VelocityCommand (Velocity 0 0)], [], [], [back 0]],
      testCase "backs off, and 0.2 s later the latest velocity of the program holds again" $
        told True [Wants (VelocityCommand (Velocity 0.3 0)), bump LeftBumper Pressed, Ticks, Wants (VelocityCommand (Velocity 0.3 0)), Ticks, bump LeftBumper Released, Ticks, Ticks, Ticks, Wants (VelocityCommand (Velocity 0.1 0))]
          @?= [[VelocityCommand (Velocity 0.3 0)], [], [back (-0.4)], [], [back (-0.4)], [], [VelocityCommand (Velocity 0.3 0)], [VelocityCommand (Velocity 0.3 0)], [VelocityCommand (Velocity 0.3 0)], [VelocityCommand (Velocity 0.1 0)]],
      testCase "does what the table says, which also holds the guard of the simulator" $ do
        cases <- C.lines <$> C.readFile "protocol/goldens/safety.jsonl"
        assertBool "cases" (length cases > 5)
        mapM_ (either assertFailure replay . (Aeson.eitherDecodeStrict' >=> parseEither tableCase)) cases,
      testGroup
        "the safety rules, first that fits"
        [ rule "a wheel in the air stands" [wheel Air, bump CenterBumper Pressed] (VelocityCommand (Velocity 0 0)),
          rule "the centre backs straight" [bump CenterBumper Pressed, bump LeftBumper Pressed] (back 0),
          rule "the left turns right" [cliff LeftCliff Hole, bump RightBumper Pressed] (back (-0.4)),
          rule "the right turns left" [bump RightBumper Pressed] (back 0.4)
        ],
      testProperty "no speed beyond the limits and no number that is none ever reaches the wheels" $ \happenings ->
        let all' = concat (told True (map fromSeed (happenings :: [(Int, Double, Double)])))
         in conjoin [counterexample (show a) (fine a) | a <- all'],
      testGroup
        "where a wheel could not follow, speed and turn are slower together: the curve stays"
        [ testCase (show asked) (withinWheels kobuki asked @?= expected)
          | (asked, expected) <- [((0.7, pi), (0.7 * (0.7 / outer), pi * (0.7 / outer))), ((0.7, 0), (0.7, 0)), ((-0.3, 3), (-0.3, 3)), ((0, pi), (0, pi))]
        ],
      testProperty "no wheel is asked for more than it can do" $
        forAll ((,) <$> choose (-5, 5) <*> choose (-20, 20)) $ \(v, w) ->
          let asked = (max (-0.7) (min 0.7 v), max (-pi) (min pi w))
           in told False [Wants (VelocityCommand (Velocity v w))] === [[VelocityCommand (uncurry Velocity (withinWheels kobuki asked))]]
                .&&. let (v', w') = withinWheels kobuki asked in counterexample (show (v', w')) (abs v' + abs w' * 0.115 <= 0.7 + 1e-9 && abs (v' * snd asked - w' * fst asked) < 1e-9),
      testCase "the limit of the wheels is a Kobuki's, of other robots none" $
        map (\name -> fmap (wheelLimit . targetLimits) (readTarget ("ws://h?robot=" ++ name))) ["kobuki", "turtlesim"] @?= [Right (Just kobuki), Right Nothing],
      testGroup
        "a robot that is told to drive and stands is noticed after a second, once, and again when it moves"
        [ testCase name (noticed happenings @?= expected)
          | (name, happenings, expected) <-
              [ ("stands", driving [place 0 0 0], [Just False]),
                ("is not told to drive", drop 1 (driving [place 0 0 0]), []),
                ("drives", driving [place (0.02 * t) 0 0 | t <- [0 .. 30]], []),
                ("turns", driving [place 0 0 (0.05 * t) | t <- [0 .. 30]], []),
                ("hears itself tremble", driving [place (0.0001 * t) 0 0.001 | t <- [0, 1]], [Just False]),
                ("stands, then moves", driving (replicate 15 (place 0 0 0) ++ [place 0.1 0 0]), [Just False, Just True]),
                ("is told to drive too slowly to tell", Wants (VelocityCommand (Velocity 0.01 0.05)) : drop 1 (driving [place 0 0 0]), []),
                ("is not watched", Watched False : driving [place 0 0 0], []),
                ("is held", Halts : driving [place 0 0 0], [])
              ]
        ],
      testCase "endless numbers and no numbers become zero" $
        told False [Wants (VelocityCommand (Velocity (0 / 0) (1 / 0)))] @?= [[VelocityCommand (Velocity 0 0)]],
      testCase "moves odometry to where the program started" $ do
        let at x y a = Received (OdometryMessage (Odometry (Position x y) (Orientation a) (Velocity 0.1 0.2)))
            g1 = snd (onEvent (at 3 4 (pi / 2)) (newGuard limits' False))
            ((ms, _), _) = onEvent (at 3 5 pi) g1
        case ms of
          [OdometryMessage (Odometry (Position x y) (Orientation a) v)] -> do
            assertBool (show (x, y, a)) (abs (x - 1) < 1e-9 && abs y < 1e-9 && abs (a - pi / 2) < 1e-9)
            v @?= Velocity 0.1 0.2
          other -> assertFailure (show other)
    ]
  where
    limits' = Limits 0.7 pi (Just kobuki)
    drive = Wants (VelocityCommand (Velocity 0.2 0))
    bump side s = Says (Received (BumperMessage (Bumper side s)))
    cliff side s = Says (Received (CliffMessage (Cliff side s)))
    wheel s = Says (Received (WheelMessage (Wheel LeftWheel s)))
    back = VelocityCommand . Velocity (-0.1)
    rule name happenings expected = testCase name $ last (told True (happenings ++ [Ticks])) @?= [expected]
    outer = 0.7 + pi * 0.115
    place x y a = Says (Received (OdometryMessage (Odometry (Position x y) (Orientation a) (Velocity 0 0))))
    -- A command, and two seconds of odometry and ticks, a tenth of a second each: the places, the last one again and again.
    driving places = drive : concat (take 20 (map (: [Ticks]) (places ++ repeat (last places))))
    noticed happenings = concat (snd (mapAccumL notice (0, snd (onEvent Connected (newGuard limits' False))) happenings))
    notice (t, g) h = case h of
      Ticks -> let (said, g') = noticeMotion t (snd (onTick t g)) in ((t + 0.1, g'), [Just yes | Just yes <- [said]])
      Says x -> ((t, snd (onEvent x g)), [])
      Wants a -> ((t, snd (onCommand t a g)), [])
      Watched yes -> ((t, snd (setWatched yes g)), [])
      Halts -> ((t, snd (haltWheels g)), [])
      _ -> ((t, g), [])
    fine a = case a of
      VelocityCommand (Velocity v w) -> abs v <= 0.7 && abs w <= pi
      _ -> True
    fromSeed (n, v, w) = case n `mod` 5 of
      0 -> Ticks
      1 -> bump LeftBumper (if v > 0 then Pressed else Released)
      2 -> Wants (VelocityCommand (Velocity (v / (w - w)) (1 / 0)))
      _ -> Wants (VelocityCommand (Velocity (v * 10) (w * 10)))

-- | kobuki_documentation, doc/specifications.rst; kobuki_core, src/driver/diff_drive.cpp.
kobuki :: Wheels
kobuki = Wheels 0.7 0.23

-- | A case of the table: its name, whether the safety rules are on, and what happens when, with the expected command.
type TableCase = (String, Bool, [(Double, Happening, Maybe (Double, Double))])

tableCase :: Object -> Parser TableCase
tableCase o = (,,) <$> o .: "case" <*> o .: "on" <*> (o .: "happenings" >>= mapM happening)
  where
    happening h = (,,) <$> h .: "at" <*> (switched h <|> wants h <|> hears h <|> ticks h) <*> h .:? "told"
    switched h = Switched <$> h .: "on"
    wants h = (\(v, w) -> Wants (VelocityCommand (Velocity v w))) <$> h .: "command"
    ticks h = do
      True <- h .: "tick"
      pure Ticks
    hears h = do
      (channel, place, number) <- h .: "hear"
      let state = number == (1 :: Int)
      Says . Received <$> case channel :: String of
        "Bumper" -> pure (BumperMessage (Bumper (toEnum place) (if state then Pressed else Released)))
        "Cliff" -> pure (CliffMessage (Cliff (toEnum place) (if state then Hole else Floor)))
        "Wheel" -> pure (WheelMessage (Wheel (toEnum place) (if state then Air else Ground)))
        _ -> fail channel

replay :: TableCase -> Assertion
replay (name, on, happenings) =
  assertEqual name [[VelocityCommand (Velocity v w) | (v, w) <- toList expected] | (_, _, expected) <- happenings] $
    toldAt (Limits 0.7 3 (Just kobuki)) on [(t, h) | (t, h, _) <- happenings]

-- | What the robot is told at each happening, a tenth of a second apart, once it is there.
told :: Bool -> [Happening] -> [[Action]]
told safe = toldAt (Limits 0.7 pi (Just kobuki)) safe . zip [0, 0.1 ..]

-- | What the robot is told at each happening at its time, seconds, once the robot is there.
toldAt :: Limits -> Bool -> [(Double, Happening)] -> [[Action]]
toldAt limits safe = snd . mapAccumL step (snd (onEvent Connected (newGuard limits safe)))
  where
    step g (t, h) = case h of
      Says x -> let ((_, as), g') = onEvent x g in (g', as)
      Wants a -> swap (onCommand t a g)
      Ticks -> swap (onTick t g)
      Halts -> swap (haltWheels g)
      Watched yes -> swap (setWatched yes g)
      Renewed -> (startRun g, [])
      Armed -> (arm g, [])
      Away -> (disarm g, [])
      Switched yes -> swap (setSafetyRules yes g)
    swap (a, b) = (b, a)
