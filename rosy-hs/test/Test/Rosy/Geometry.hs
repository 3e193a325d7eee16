-- |
-- Module      : Test.Rosy.Geometry
-- Description : Angles and vectors do what their names say.
module Test.Rosy.Geometry (tests) where

import Rosy
import Test.QuickCheck hiding (scale)
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck (testProperty)

tests :: TestTree
tests =
  testGroup
    "Geometry"
    [ testProperty "a normal angle is above -π and up to π, and looks the same way" $ \(Blind r) ->
        let n = normRadians r in counterexample (show (r, n)) (n > negate pi && n <= pi && near (cos n) (cos r) && near (sin n) (sin r)),
      testCase "π stays π, and -π becomes π" $ map normRadians [pi, negate pi, 3 * pi, -3 * pi] @?= replicate 4 pi,
      testCase "an angle that is normal is not touched" $ map normRadians [0, 1, -1, 3.14] @?= [0, 1, -1, 3.14],
      testProperty "degrees there and back" $ \d -> near (orientationToDegrees (degreesToOrientation d)) d,
      testCase "a right angle" $ degreesToOrientation 90 @?= Orientation (pi / 2),
      testProperty "centimetres there and back" $ \c -> near (metersToCentimeters (centimetersToMeters c)) c,
      testProperty "a vector is its length and its angle" $ \x y ->
        let (x', y') = scalarVec (magnitudeVec (x, y)) (angleVec (x, y)) in near x x' && near y y',
      testProperty "what was added can be taken away" $ \(x, y) v -> let (x', y') = subVec (addVec (x, y) v) v in near x x' && near y y',
      testProperty "extending keeps the direction" $ \(Positive x) y (Positive d) ->
        near (magnitudeVec (extVec (x, y) d)) (magnitudeVec (x, y) + d) && near (angleVec (extVec (x, y) d)) (angleVec (x, y)),
      testProperty "positions and vectors are the same numbers" $ \x y -> vecToPosition (positionToVec (Position x y)) === Position x y,
      testCase "a line through a circle, a tangent, a line beside it, and no line" $
        [circleLineIntersection ((1, 1), 2) line | line <- [((-3, 1), (1, 1)), ((0, 3), (1, 3)), ((0, 4), (1, 4)), ((1, 1), (1, 1))]]
          @?= [[(3, 1), (-1, 1)], [(1, 3)], [], []],
      testProperty "a circle and a line meet on both" $ \centre (Positive radius) from to ->
        and [near (distVec centre p) radius && near (crossProdVec (subVec to from) (subVec p from)) 0 | distVec from to > 0.1, p <- circleLineIntersection (centre, radius) (from, to)],
      testCase "orientations and seconds are numbers" $ (realToFrac (Orientation 1 + 0.5) :: Double, 2 * Seconds 3 > 5) @?= (1.5, True)
    ]
  where
    near a b = abs (a - b) <= 1e-6 * (1 + abs a + abs (b :: Double))
