-- |
-- Module      : Ros.Util.PID
-- Description : PID controllers of single values, as roshask has them.
--
-- The error is the value minus the setpoint: a value that is too large gives a positive signal with a positive gain. "Ros.Topic.PID" has
-- the opposite sign, and an integral over all that was, where this one is over the last three errors (Simpson's rule).
--
-- The gains come first: proportional, integral, derivative.
module Ros.Util.PID
  ( -- * One step
    pidUniform,
    pidFixed,
    pidTimed,

    -- * Controllers that remember the last two errors
    pidUniformIO,
    pidFixedIO,
    pidTimedIO,
    pidWithTimeIO,
  )
where

import Data.IORef (newIORef, readIORef, writeIORef)
import GHC.Clock (getMonotonicTime)

-- | Gains, setpoint, the two errors before, the value. Gives its error and the signal. Values are one unit of time apart.
pidUniform :: Fractional a => a -> a -> a -> a -> a -> a -> a -> (a, a)
pidUniform kp ki kd setpoint = pidFixed kp ki kd setpoint 1

-- | The same with values so many seconds apart, which follow the setpoint.
pidFixed :: Fractional a => a -> a -> a -> a -> a -> a -> a -> a -> (a, a)
pidFixed kp ki kd setpoint dt = signal kp ki (kd / dt) setpoint (2 * dt)

-- | Errors and value with their times, seconds. The derivative part is the difference of the last two errors, which is not divided by the time
-- between them: values may come at one time.
pidTimed :: Fractional a => a -> a -> a -> a -> (a, a) -> (a, a) -> (a, a) -> (a, a)
pidTimed kp ki kd setpoint (start, e1) (_, e2) (end, x) = signal kp ki kd setpoint (end - start) e1 e2 x

-- | The derivative gain is that of a difference. The time is that from the first error to the value.
signal :: Fractional a => a -> a -> a -> a -> a -> a -> a -> a -> (a, a)
signal kp ki kd setpoint time e1 e2 x = (e3, kp * e3 + ki * integral + kd * (e3 - e2))
  where
    e3 = x - setpoint
    integral = time / 6 * (e1 + 4 * e2 + e3)

-- | Gains. The controller gets setpoint and value; its first two signals are zero, as those of all below.
pidUniformIO :: Fractional a => a -> a -> a -> IO (a -> a -> IO a)
pidUniformIO kp ki kd = pidFixedIO kp ki kd 1

-- | Gains, seconds between values.
pidFixedIO :: Fractional a => a -> a -> a -> a -> IO (a -> a -> IO a)
pidFixedIO kp ki kd dt = remembering subtract (\setpoint e1 e2 x -> snd (pidFixed kp ki kd setpoint dt e1 e2 x))

-- | The times are those at which the controller gets the values, by a clock that nobody sets.
pidTimedIO :: Fractional a => a -> a -> a -> IO (a -> a -> IO a)
pidTimedIO kp ki kd = do
  control <- pidWithTimeIO kp ki kd
  start <- getMonotonicTime
  pure (\setpoint x -> getMonotonicTime >>= \now -> control setpoint (realToFrac (now - start), x))

-- | Times in seconds come with the values.
pidWithTimeIO :: Fractional a => a -> a -> a -> IO (a -> (a, a) -> IO a)
pidWithTimeIO kp ki kd = remembering (\setpoint (time, x) -> (time, x - setpoint)) (\setpoint e1 e2 x -> snd (pidTimed kp ki kd setpoint e1 e2 x))

-- | What to remember of a setpoint and a value, and the signal from the last two of these.
remembering :: Num a => (s -> x -> e) -> (s -> e -> e -> x -> a) -> IO (s -> x -> IO a)
remembering errorOf step = do
  past <- newIORef []
  pure $ \setpoint x -> do
    before <- readIORef past
    let e = errorOf setpoint x
    e `seq` writeIORef past (drop (length before - 1) before ++ [e])
    pure $ case before of
      [e1, e2] -> step setpoint e1 e2 x
      _ -> 0
