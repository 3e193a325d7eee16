-- |
-- Module      : Ros.Topic.PID
-- Description : PID controllers: measured values in, control signals out.
--
-- The names are roshask's: @Uniform@ takes one unit of time between values, @Fixed@ a given time, @Timed@ the time of the system's clock, and
-- @Stamped@ times that come with the values. With a @2@ the setpoint is a topic too. The error is setpoint minus value, unlike in roshask and
-- in "Ros.Util.PID". The first value has no past, so its signal is the proportional part alone, and so is that of a value that is no newer
-- than the one before, with the integral so far.
module Ros.Topic.PID
  ( pidUniform,
    pidUniform2,
    pidFixed,
    pidFixed2,
    pidTimed,
    pidTimed2,
    pidStamped,
    pidStamped2,
  )
where

import Control.Monad.IO.Class (MonadIO (..))
import Data.Time.Clock.POSIX (getPOSIXTime)
import Ros.Topic (Topic)
import qualified Ros.Topic as Topic
import Ros.Topic.Util (everyNew)

-- | Gains, setpoint, values one unit of time apart.
pidUniform :: (Fractional a, Ord a, Monad m) => a -> a -> a -> a -> Topic m a -> Topic m a
pidUniform kp ki kd setpoint = pidFixed kp ki kd setpoint 1

pidUniform2 :: (Fractional a, Ord a) => a -> a -> a -> Topic IO a -> Topic IO a -> Topic IO a
pidUniform2 kp ki kd = pidFixed2 kp ki kd 1

-- | Gains, setpoint, seconds between values.
pidFixed :: (Fractional a, Ord a, Monad m) => a -> a -> a -> a -> a -> Topic m a -> Topic m a
pidFixed kp ki kd setpoint dt = pidStamped kp ki kd setpoint . every dt

pidFixed2 :: (Fractional a, Ord a) => a -> a -> a -> a -> Topic IO a -> Topic IO a -> Topic IO a
pidFixed2 kp ki kd dt setpoints values = control kp ki kd (fmap stamped (every dt (everyNew setpoints values)))
  where
    stamped (time, (setpoint, value)) = (time, setpoint - value)

-- | Gains, setpoint, values that are measured now.
pidTimed :: (Fractional a, Ord a, MonadIO m) => a -> a -> a -> a -> Topic m a -> Topic m a
pidTimed kp ki kd setpoint = pidStamped kp ki kd setpoint . Topic.mapM now

pidTimed2 :: (Fractional a, Ord a) => a -> a -> a -> Topic IO a -> Topic IO a -> Topic IO a
pidTimed2 kp ki kd setpoints values = control kp ki kd (Topic.mapM (now . uncurry (-)) (everyNew setpoints values))

-- | Gains, setpoint, times in seconds with values.
pidStamped :: (Fractional a, Ord a, Monad m) => a -> a -> a -> a -> Topic m (a, a) -> Topic m a
pidStamped kp ki kd setpoint = control kp ki kd . fmap (fmap (setpoint -))

pidStamped2 :: (Fractional a, Ord a) => a -> a -> a -> Topic IO a -> Topic IO (a, a) -> Topic IO a
pidStamped2 kp ki kd setpoints values = control kp ki kd (fmap (\(setpoint, (time, value)) -> (time, setpoint - value)) (everyNew setpoints values))

-- | Times at equal distances, the first one zero.
every :: (Num a, Monad m) => a -> Topic m b -> Topic m (a, b)
every dt = Topic.mapAccum (\time x -> ((time, x), time + dt)) 0

now :: (Fractional a, MonadIO m) => b -> m (a, b)
now x = (\time -> (realToFrac time, x)) <$> liftIO getPOSIXTime

-- | Time and error before, and the integral.
data Past a = None | Past !a !a !a

-- | Gains, and errors with their times.
control :: (Fractional a, Ord a, Monad m) => a -> a -> a -> Topic m (a, a) -> Topic m a
control kp ki kd = Topic.mapAccum step None
  where
    step None (time, e) = (kp * e, Past time e 0)
    step (Past before e' integral) (time, e)
      | dt > 0 = (kp * e + ki * sum' + kd * (e - e') / dt, Past time e sum')
      | otherwise = (kp * e + ki * integral, Past before e integral)
      where
        dt = time - before
        sum' = integral + e * dt
