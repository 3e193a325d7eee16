-- |
-- Module      : Ros.Rate
-- Description : At most so many times a second.
module Ros.Rate
  ( rateLimiter,
    micros,
  )
where

import Control.Concurrent (threadDelay)
import Control.Monad (when)
import Data.IORef (newIORef, readIORef, writeIORef)
import GHC.Clock (getMonotonicTime)

-- | An action that runs the given one at most @hz@ times a second: at once the first time, later after
-- waiting until its turn. A late caller does not catch up.
rateLimiter :: Double -> IO a -> IO (IO a)
rateLimiter hz act = do
  due <- newIORef Nothing
  pure $ do
    now <- getMonotonicTime
    turn <- maybe now (max now) <$> readIORef due
    when (turn > now) (threadDelay (micros (turn - now)))
    writeIORef due (Just (turn + 1 / hz))
    act

-- | Seconds as 'threadDelay' wants them, never early.
micros :: Double -> Int
micros s = ceiling (s * 1e6)
