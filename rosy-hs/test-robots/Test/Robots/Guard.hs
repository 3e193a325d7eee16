-- |
-- Description : What stands between a program and real wheels.
module Test.Robots.Guard (tests) where

import Data.List (mapAccumL)
import Rosy.Core (Action (..), Message (..), Odometry (..))
import Rosy.Robot
import Rosy.Robots.Base
import Rosy.Robots.Guard
import Test.Tasty
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

-- | What can happen to a guard, a tenth of a second apart.
data Happening = Says Heard | Wants Action | Ticks | Halts | Watched Bool | Renewed
  deriving (Show)

tests :: TestTree
tests =
  testGroup
    "the guard"
    [ testCase "repeats a velocity that is not zero, and zero only once" $
        told False [Wants (SetVelocity 0.2 0), Ticks, Ticks, Wants (SetVelocity 0 0), Ticks]
          @?= [[SetVelocity 0.2 0], [SetVelocity 0.2 0], [SetVelocity 0.2 0], [SetVelocity 0 0], []],
      testCase "tells a robot that is lost to stand, and forgets its velocity" $
        told False [Wants (SetVelocity 0.2 0), Says (Gone "away"), Ticks, Wants (SetVelocity 0.3 0), Says Here, Ticks]
          @?= [[SetVelocity 0.2 0], [SetVelocity 0 0], [], [], [], []],
      testCase "tells the program that the robot is lost, once" $
        fst (hearing (Gone "x") (snd (hearing (Gone "x") (snd (hearing Here (newGuard limits' False)))))) @?= ([], []),
      testCase "lets nothing move after a halt" $
        told False [Wants (SetVelocity 0.2 0), Halts, Ticks, Wants (SetVelocity 0.2 0), Wants (SetLed1 Red)]
          @?= [[SetVelocity 0.2 0], [SetVelocity 0 0], [], [], [SetLed1 Red]],
      testCase "stands while nobody watches, and goes on when somebody does" $
        told False [Wants (SetVelocity 0.2 0), Watched True, Watched False, Watched False, Ticks, Wants (SetVelocity 0.3 0), Watched True, Ticks]
          @?= [[SetVelocity 0.2 0], [], [SetVelocity 0 0], [], [], [], [], [SetVelocity 0.3 0]],
      testCase "does not back off while nobody watches" $
        told True [Watched False, bump LeftBumper Pressed, Ticks, Watched True, Ticks] @?= [[SetVelocity 0 0], [], [], [], [back (-0.4)]],
      testCase "begins anew after a halt, with nothing left of the velocity and all of what is pressed" $
        told True [Wants (SetVelocity 0.2 0), Halts, bump CenterBumper Pressed, Renewed, Ticks] @?= [[SetVelocity 0.2 0], [SetVelocity 0 0], [], [], [back 0]],
      testCase "backs off before the program may drive again, and then stands until it says something" $
        told True [Wants (SetVelocity 0.3 0), bump LeftBumper Pressed, Ticks, Wants (SetVelocity 0.3 0), Ticks, bump LeftBumper Released, Ticks, Ticks, Ticks, Wants (SetVelocity 0.1 0)]
          @?= [[SetVelocity 0.3 0], [], [back (-0.4)], [], [back (-0.4)], [], [SetVelocity 0 0], [], [], [SetVelocity 0.1 0]],
      testGroup
        "the safety rules, first that fits"
        [ rule "a wheel in the air stands" [wheel Air, bump CenterBumper Pressed] (SetVelocity 0 0),
          rule "the centre backs straight" [bump CenterBumper Pressed, bump LeftBumper Pressed] (back 0),
          rule "the left turns right" [cliff LeftCliff Hole, bump RightBumper Pressed] (back (-0.4)),
          rule "the right turns left" [bump RightBumper Pressed] (back 0.4)
        ],
      testProperty "no speed beyond the limits and no number that is none ever reaches the wheels" $ \happenings ->
        let all' = concat (told True (map fromSeed (happenings :: [(Int, Double, Double)])))
         in conjoin [counterexample (show a) (fine a) | a <- all'],
      testCase "endless numbers and no numbers become zero" $
        told False [Wants (SetVelocity (0 / 0) (1 / 0))] @?= [[SetVelocity 0 0]],
      testCase "moves odometry to where the program started" $ do
        let at x y a = Heard (OdometryMessage (Odometry (Position x y) (Orientation a) (Velocity 0.1 0.2)))
            g1 = snd (hearing (at 3 4 (pi / 2)) (newGuard limits' False))
            ((ms, _), _) = hearing (at 3 5 pi) g1
        case ms of
          [OdometryMessage (Odometry (Position x y) (Orientation a) v)] -> do
            assertBool (show (x, y, a)) (abs (x - 1) < 1e-9 && abs y < 1e-9 && abs (a - pi / 2) < 1e-9)
            v @?= Velocity 0.1 0.2
          other -> assertFailure (show other)
    ]
  where
    limits' = Limits 0.7 pi
    bump side s = Says (Heard (BumperMessage (Bumper side s)))
    cliff side s = Says (Heard (CliffMessage (Cliff side s)))
    wheel s = Says (Heard (WheelMessage (Wheel LeftWheel s)))
    back = SetVelocity (-0.1)
    rule name happenings expected = testCase name $ last (told True (happenings ++ [Ticks])) @?= [expected]
    fine a = case a of
      SetVelocity v w -> abs v <= 0.7 && abs w <= pi
      _ -> True
    fromSeed (n, v, w) = case n `mod` 5 of
      0 -> Ticks
      1 -> bump LeftBumper (if v > 0 then Pressed else Released)
      2 -> Wants (SetVelocity (v / (w - w)) (1 / 0))
      _ -> Wants (SetVelocity (v * 10) (w * 10))

-- | What the robot is told at each happening, once it is there.
told :: Bool -> [Happening] -> [[Action]]
told safe = snd . mapAccumL step (snd (hearing Here (newGuard (Limits 0.7 pi) safe))) . zip [0, 0.1 ..]
  where
    step g (t, h) = case h of
      Says x -> let ((_, as), g') = hearing x g in (g', as)
      Wants a -> swap (commanding t a g)
      Ticks -> swap (ticking t g)
      Halts -> swap (halting g)
      Watched yes -> swap (watching yes g)
      Renewed -> (renewing g, [])
    swap (a, b) = (b, a)
