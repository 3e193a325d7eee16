{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Rosy.LaserScan
-- Description : Laser scans as drivers write them: what meets nothing, what is too near, and which beams look ahead.
module Test.Rosy.LaserScan (tests) where

import Data.Aeson (Value (Null), object, toJSON, (.=))
import Rosy.Channel (tellMessage)
import Rosy.Codec (readMessages, routes)
import Rosy.LaserScan
import Rosy.Profile (Robot (..))
import Rosy.Robot.Known (robots)
import Rosy.Wire (Line (SensorLine), readLine)
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "Laser scans"
    [ testCase "a beam that meets nothing says the longest distance, however the driver writes it" $
        scanRanges <$> scanIn (scan 0 1 [toJSON (0 :: Double), Null, toJSON (7 :: Double), toJSON (-1 :: Double), toJSON (2 :: Double)])
          @?= Right [3.5, 3.5, 3.5, 3.5, 2],
      testCase "what is nearer than can be measured says the shortest distance" $
        scanRanges <$> scanIn (scan 0 1 [toJSON (0.05 :: Double)]) @?= Right [0.12],
      testCase "ahead is the nearest of the beams within ten degrees, to the left and to the right" $ do
        ahead (replicate 360 2) @?= Right 2
        -- Beam 350 looks ten degrees to the right, beam 349 further.
        ahead [if i == (350 :: Int) then 1 else 2 | i <- [0 .. 359]] @?= Right 1
        ahead [if i == (349 :: Int) || i == 11 then 1 else 2 | i <- [0 .. 359]] @?= Right 2,
      testCase "a scanner that turns clockwise and begins behind the robot has the same way ahead" $
        nearestAhead tenDegrees (scan pi (negate degree) [toJSON (if i == (180 :: Int) then 1 else 2 :: Double) | i <- [0 .. 359]]) @?= Right 1,
      testCase "a scan that does not look ahead has no way ahead" $
        nearestAhead tenDegrees (scan 1 degree (replicate 90 (toJSON (1 :: Double)))) @?= Left "no beam of the scan looks ahead",
      testCase "what is no scan says what is missing" $
        scanIn (object ["ranges" .= ([1] :: [Double])]) @?= Left "\"range_min\" is not a number",
      testGroup
        "a message on /scan is both, the way ahead and the scan"
        [ testCase (robotName robot ++ ", " ++ profile) $
            fmap (map (take 10 . tellMessage)) (readMessages (routes robot variables) "/scan" (scan 0 degree [toJSON (1.5 :: Double)]))
              @?= Right ["Ahead 1.5", "Scan 0.0 1"]
          | robot <- robots,
            robotName robot `elem` ["kobuki", "turtlebot3"],
            (profile, variables) <- robotProfiles robot
        ],
      testCase "on the robot link they are two messages" $ do
        fmap told (readLine "{\"op\":\"publish\",\"topic\":\"/scan\",\"msg\":{\"ahead\":0.8}}") @?= Right ["Ahead 0.8"]
        fmap told (readLine "{\"op\":\"publish\",\"topic\":\"/scan\",\"msg\":{\"angle_min\":0,\"angle_increment\":1,\"range_min\":0.12,\"range_max\":3.5,\"ranges\":[0.8,3.5]}}")
          @?= Right ["Scan 0.0 1.0 0.12 3.5 [0.8,3.5]"]
    ]
  where
    degree = pi / 180
    tenDegrees = 10 * degree
    ahead :: [Double] -> Either String Double
    ahead distances = nearestAhead tenDegrees (scan 0 degree (map toJSON distances))
    told line = case line of
      SensorLine messages -> map tellMessage messages
      _ -> []

-- | A message of the LDS-01 with these distances.
scan :: Double -> Double -> [Value] -> Value
scan first increment ranges =
  object ["angle_min" .= first, "angle_increment" .= increment, "range_min" .= (0.12 :: Double), "range_max" .= (3.5 :: Double), "ranges" .= ranges]
