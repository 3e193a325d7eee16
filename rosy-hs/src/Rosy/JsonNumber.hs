{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.JsonNumber
-- Description : Numbers of messages in JSON, with those that JSON has no word for.
--
-- Pure. ROS's numbers may be infinite or not a number. Inside of Rosy an infinite one is a JSON number beyond all doubles, and what is not a number
-- is a text, so that both pass through every JSON library between a robot and a program.
module Rosy.JsonNumber
  ( doubleIn,
    finiteIn,
    doubleValue,
    isNotANumber,
  )
where

import Data.Aeson (Value (..))
import Data.Scientific (fromFloatDigits, scientific, toBoundedRealFloat)

-- | The number in a value, which may be infinite or not a number.
doubleIn :: Value -> Maybe Double
doubleIn v = case v of
  -- Beyond a double's range this is infinite, or zero.
  Number n -> Just (either id id (toBoundedRealFloat n))
  _ | isNotANumber v -> Just (0 / 0)
  _ -> Nothing

-- | The number in a value, unless it is infinite or not a number.
finiteIn :: Value -> Maybe Double
finiteIn v = case v of
  Number n -> either (\x -> if x == 0 then Just 0 else Nothing) Just (toBoundedRealFloat n)
  _ -> Nothing

-- | The value of a number; the inverse of 'doubleIn'.
doubleValue :: Double -> Value
doubleValue x
  | isNaN x = notANumber
  | isInfinite x = Number (scientific (if x > 0 then 1 else -1) 999)
  | otherwise = Number (fromFloatDigits x)

notANumber :: Value
notANumber = String "NaN"

-- | Whether a value stands for what is not a number.
isNotANumber :: Value -> Bool
isNotANumber = (== notANumber)
