-- |
-- Module      : Rosy.Robots.BootClock
-- Description : A clock that runs while the computer sleeps.
--
-- Linux's CLOCK_BOOTTIME (clock_gettime(2)). The monotonic clock of GHC stands still while a laptop sleeps, so a velocity from before would look new.
module Rosy.Robots.BootClock
  ( bootSeconds,
  )
where

-- | Seconds since the computer was started.
foreign import ccall unsafe "rosy_boot_seconds" bootSeconds :: IO Double
