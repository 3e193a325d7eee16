{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.LaserScan
-- Description : Laser scans of ROS (@sensor_msgs\/LaserScan@) as JSON: the distances, and how far the way ahead is free.
--
-- Pure. Drivers write a beam that meets nothing as 0 (@hls_lfcd_lds_driver@), as infinity (REP 117) or, in JSON, as @null@. Here such a
-- beam reads as the longest distance that the sensor can measure: that far the way is free. What is nearer
-- than the shortest distance that it can measure reads as that distance. A beam that is not a number is no reading (REP 117).
module Rosy.LaserScan
  ( LaserScan (..),
    scanIn,
    scanRanges,
    nearestAhead,
  )
where

import Data.Aeson (Value (Array, Object))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (toList)
import Data.Maybe (fromMaybe)
import Rosy.JsonNumber (finiteIn, isNotANumber)

-- | Angles in rad, counter-clockwise with 0 straight ahead; distances in m, none greater than the longest that the sensor can measure, which
-- stands before them. A beam without a reading has none.
data LaserScan = LaserScan {scanFirst :: Double, scanIncrement :: Double, scanFurthest :: Double, scanReadings :: [Maybe Double]}
  deriving (Eq, Show)

-- | The distance of every beam, m. Without a reading it is the longest one, because programs count on a number for each beam.
scanRanges :: LaserScan -> [Double]
scanRanges scan = map (fromMaybe (scanFurthest scan)) (scanReadings scan)

-- | The scan in a message, or why there is none.
scanIn :: Value -> Either String LaserScan
scanIn message = do
  nearest <- numberAt "range_min"
  furthest <- numberAt "range_max"
  LaserScan <$> numberAt "angle_min" <*> numberAt "angle_increment" <*> pure furthest <*> (map (measured nearest furthest) <$> listAt "ranges")
  where
    listAt name = case field name of
      Just (Array found) -> Right (toList found)
      _ -> Left "\"ranges\" is not a list"
    numberAt name = maybe (Left (show name ++ " is not a number")) Right (field name >>= finiteIn)
    field name = case message of
      Object o -> KeyMap.lookup name o
      _ -> Nothing
    measured nearest furthest reading = case finiteIn reading of
      _ | isNotANumber reading -> Nothing
      Just r | r > 0 || nearest <= 0, r <= furthest -> Just (max nearest r)
      _ -> Just furthest

-- | The smallest distance of the beams that are at most this angle (rad) from straight ahead, or why there is none.
nearestAhead :: Double -> Value -> Either String Double
nearestAhead within message = do
  LaserScan first increment _ readings <- scanIn message
  case [r | (i, Just r) <- zip [0 :: Int ..] readings, abs (wrapped (first + fromIntegral i * increment)) <= within + rounding] of
    [] -> Left "no beam of the scan looks ahead"
    ahead -> Right (minimum ahead)
  where
    wrapped a = a - 2 * pi * fromIntegral (round (a / (2 * pi)) :: Int)
    -- Angles of messages have single precision.
    rounding = 1e-5
