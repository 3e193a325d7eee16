-- |
-- Module      : Measure
-- Description : Seconds that something takes, several times, and a line about it.
module Measure
  ( times,
    line,
    decimals,
  )
where

import Control.Monad (replicateM)
import Data.List (sort)
import GHC.Clock (getMonotonicTime)
import Numeric (showFFloat)
import System.Mem (performMajorGC)

-- | Seconds of each of so many runs.
times :: Int -> IO () -> IO [Double]
times n act = replicateM n $ do
  performMajorGC
  before <- getMonotonicTime
  act
  after <- getMonotonicTime
  pure (after - before)

-- | A name, how many instants and firings, and the seconds of each run: the median and the slowest.
line :: String -> Int -> Int -> [Double] -> IO ()
line name instants firings seconds =
  putStrLn $
    pad 28 name
      ++ pad 26 (thousands (fromIntegral instants / middle) ++ " instants/s")
      ++ pad 26 (thousands (fromIntegral firings / middle) ++ " firings/s")
      ++ decimals 2 (middle / fromIntegral firings * 1e6)
      ++ " µs a firing (slowest run "
      ++ decimals 2 (maximum seconds / fromIntegral firings * 1e6)
      ++ ")"
  where
    middle = sort seconds !! (length seconds `div` 2)
    pad k s = s ++ replicate (k - length s) ' '

-- | A number in thousands.
thousands :: Double -> String
thousands x = decimals 0 (x / 1000) ++ " thousand"

-- | With so many decimals.
decimals :: Int -> Double -> String
decimals d x = showFFloat (Just d) x ""
