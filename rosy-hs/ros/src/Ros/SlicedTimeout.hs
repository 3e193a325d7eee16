-- |
-- Module      : Ros.SlicedTimeout
-- Description : Timeouts that tolerate pauses of this computer.
--
-- A timeout is counted in slices, and a pause of any length, of a busy computer or one in standby, uses up one slice. What arrived
-- during the pause is noticed before the timeout is over.
module Ros.SlicedTimeout
  ( timeoutInSlices,
    delayInSlices,
  )
where

import Control.Concurrent (threadDelay)
import Control.Monad (replicateM_)
import System.Timeout (timeout)

-- | A timeout in microseconds. The action is begun again in each slice: it waits, and changes nothing before it has what it waits for.
timeoutInSlices :: Int -> IO a -> IO (Maybe a)
timeoutInSlices limit act = go slices
  where
    go left
      | left == 0 = pure Nothing
      | otherwise = timeout (limit `div` slices) act >>= maybe (go (left - 1)) (pure . Just)

-- | A delay in microseconds.
delayInSlices :: Int -> IO ()
delayInSlices limit = replicateM_ slices (threadDelay (limit `div` slices))

slices :: Int
slices = 10
