{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Rosy.Value.DecimalDigits
-- Description : 'showsPrec' for @Double@, with machine words instead of big integers where these suffice.
--
-- Each firing of an observed run shows some ten numbers (rule R12), and 'showsPrec' takes a microsecond and 7 kB of memory for one. For numbers
-- between 0.1 and 10,000,000, which 'showsPrec' writes without an exponent, all intermediate results of its algorithm are below 2^63. Zero,
-- the most frequent number of a robot that drives straight on, needs no algorithm.
-- Pure.
--
-- > showsDouble d x s = showsPrec d x s
module Rosy.Value.DecimalDigits
  ( showsDouble,
  )
where

import Data.Bits (shiftL, shiftR, (.&.), (.|.))
import Data.Char (intToDigit)
import Data.Word (Word64)
import GHC.Float (castDoubleToWord64)

-- | As 'showsPrec'.
showsDouble :: Int -> Double -> ShowS
showsDouble d x
  | x >= 0.1 && x < 1e7 = fixed x
  | castDoubleToWord64 x == 0 = showString "0.0"
  | x <= -0.1 && x > -1e7 = showParen (d > 6) (showChar '-' . fixed (negate x))
  | otherwise = showsPrec d x

-- | The shortest digits that tell the number from its neighbours: 'Numeric.floatToDigits', after Burger and Dybvig, "Printing Floating-Point Numbers
-- Quickly and Accurately" (1996). The number is @f * 2^e@, and @r / s@; the distance to the neighbours' halves is @above / s@ and @below / s@.
fixed :: Double -> ShowS
fixed x end = digits 0 0 r above below
  where
    bits = castDoubleToWord64 x
    f = (bits .&. (hidden - 1)) .|. hidden
    -- Negative, for the number is below 2^52.
    e = fromIntegral (bits `shiftR` 52) - 1075 :: Int
    hidden = 1 `shiftL` 52
    -- The lower neighbour of a power of two is nearer than the upper one.
    isPower = f == hidden
    !r = f `shiftL` (if isPower then 2 else 1)
    !s = 1 `shiftL` ((if isPower then 2 else 1) - e)
    above = if isPower then 2 else 1
    below = 1
    -- How many digits are before the point, and @s@ times ten to the power of that.
    !places = scale 0 s
    !whole = s * 10 ^ places
    scale :: Int -> Word64 -> Int
    scale !k !p = if r + above <= p then k else scale (k + 1) (p * 10)
    -- So many digits so far, as a number; what is left of @r@; both distances.
    digits :: Int -> Word64 -> Word64 -> Word64 -> Word64 -> String
    digits !n !sofar !rest !up !down
      | enough && (not over || left * 2 < whole) = written (n + 1) (sofar * 10 + digit) places end
      | enough || over = written (n + 1) (sofar * 10 + digit + 1) places end
      | otherwise = digits (n + 1) (sofar * 10 + digit) left (up * 10) (down * 10)
      where
        !digit = (rest * 10) `quot` whole
        !left = (rest * 10) - digit * whole
        enough = left < down * 10
        over = left + up * 10 > whole

-- | So many digits, with the point after the first @places@ of them.
written :: Int -> Word64 -> Int -> String -> String
written n number places end
  | n <= places = whole (number * 10 ^ (places - n)) ('.' : '0' : end)
  | otherwise = fraction (n - places) number end
  where
    fraction :: Int -> Word64 -> String -> String
    fraction 0 !k after = whole k ('.' : after)
    fraction m !k after = case k `quotRem` 10 of
      (more, digit) -> let !c = digitOf digit in fraction (m - 1) more (c : after)
    whole :: Word64 -> String -> String
    whole !k after = case k `quotRem` 10 of
      (more, digit) -> let !c = digitOf digit in if more == 0 then c : after else whole more (c : after)

digitOf :: Word64 -> Char
digitOf = intToDigit . fromIntegral
