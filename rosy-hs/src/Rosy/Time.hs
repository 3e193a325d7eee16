{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE GeneralizedNewtypeDeriving #-}

-- |
-- Module      : Rosy.Time
-- Description : Seconds and the time of day, as programs read them.
module Rosy.Time
  ( Seconds (..),
    Clock (..),
    clockAt,
  )
where

import GHC.Generics (Generic)
import Rosy.Value (Default, Value (..))
import Text.Read (Read (..), lexP, parens, prec, step)
import qualified Text.Read as Read (Lexeme (Ident), readListPrecDefault)

-- | Seconds since the start of the program, from a monotonic clock (rule R21). A number like any other.
newtype Seconds = Seconds Double
  deriving (Eq, Ord, Show, Read, Generic, Num, Fractional, Floating, Real, RealFrac, RealFloat, Enum)

-- | The time of day: hours, minutes, seconds and milliseconds. On a simulator the day begins with the program;
-- on a robot it is universal time (UTC).
data Clock = Clock
  { -- | 0 to 23.
    hours :: !Int,
    -- | 0 to 59.
    minutes :: !Int,
    -- | 0 to 59, of the minute.
    seconds :: !Int,
    -- | 0 to 999, of the second.
    milliseconds :: !Int
  }
  deriving (Eq, Ord, Generic)

instance Show Clock where
  showsPrec d (Clock h m s ms) = showParen (d > 10) (showString "Clock" . foldMap' (\n -> showChar ' ' . showsPrec 11 n) [h, m, s, ms])
    where
      foldMap' f = foldr ((.) . f) id

instance Read Clock where
  readPrec = parens (prec 10 (do Read.Ident "Clock" <- lexP; Clock <$> step readPrec <*> step readPrec <*> step readPrec <*> step readPrec))
  readListPrec = Read.readListPrecDefault

instance Value Seconds

instance Default Seconds

instance Value Clock where display = showsPrec

instance Default Clock

-- | Hours, minutes, seconds and milliseconds of so many seconds, modulo a day.
clockAt :: Double -> Clock
clockAt time = Clock (s `div` 3600 `mod` 24) (s `div` 60 `mod` 60) (s `mod` 60) ms
  where
    -- The simulator counts steps of 20 ms: half a millisecond more absorbs the rounding of 0.02 * k.
    (s, ms) = (floor (time * 1000 + 0.5) :: Int) `divMod` 1000
