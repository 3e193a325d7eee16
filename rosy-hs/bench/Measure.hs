-- |
-- Module      : Measure
-- Description : What something costs, several times in turn with its peer, and a line about it.
module Measure
  ( Cost (..),
    inTurn,
    ratio,
    median,
    line,
    decimals,
  )
where

import Control.Monad (replicateM)
import Data.List (sort, transpose)
import GHC.Stats (allocated_bytes, getRTSStats)
import Numeric (showFFloat)
import System.CPUTime (getCPUTime)
import System.Mem (performMajorGC)

-- | What runs cost: seconds of processor time of each, and bytes that one allocates.
data Cost = Cost {seconds :: [Double], bytes :: Double}

-- | The costs of several things, each done so many times in turn, so that a busy moment of the machine meets all of them.
inTurn :: Int -> [IO ()] -> IO [Cost]
inTurn n acts = do
  rounds <- replicateM n (mapM once acts)
  pure [Cost (map fst runs) (snd (head runs)) | runs <- transpose rounds]
  where
    once act = do
      performMajorGC
      allocated <- allocated_bytes <$> getRTSStats
      before <- getCPUTime
      _ <- act
      after <- getCPUTime
      allocated' <- allocated_bytes <$> getRTSStats
      pure (fromIntegral (after - before) / 1e12, fromIntegral (allocated' - allocated))

-- | How many times as long the first takes as the second, in the middle of the rounds.
ratio :: Cost -> Cost -> Double
ratio a b = median (zipWith (/) (seconds a) (seconds b))

-- | The middle one.
median :: [Double] -> Double
median xs = sort xs !! (length xs `div` 2)

-- | A name, how many instants and firings, and what they cost: the median and the slowest.
line :: String -> Int -> Int -> Cost -> IO ()
line name instants firings cost =
  putStrLn $
    pad 28 name
      ++ pad 26 (thousands (fromIntegral instants / middle) ++ " instants/s")
      ++ pad 26 (thousands (fromIntegral firings / middle) ++ " firings/s")
      ++ pad 52 (decimals 2 (perFiring middle * 1e6) ++ " µs a firing (slowest run " ++ decimals 2 (perFiring (maximum (seconds cost)) * 1e6) ++ ")")
      ++ decimals 0 (perFiring (bytes cost))
      ++ " bytes a firing"
  where
    middle = median (seconds cost)
    perFiring x = x / fromIntegral firings
    pad k s = s ++ replicate (k - length s) ' '

-- | A number in thousands.
thousands :: Double -> String
thousands x = decimals 0 (x / 1000) ++ " thousand"

-- | With so many decimals.
decimals :: Int -> Double -> String
decimals d x = showFFloat (Just d) x ""
