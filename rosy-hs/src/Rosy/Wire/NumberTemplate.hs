{-# LANGUAGE ForeignFunctionInterface #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Wire.NumberTemplate
-- Description : Template of a line of JSON in which only the numbers differ.
--
-- The odometry and the end of a step come fifty times in a simulated second, with the same text around their numbers. A template is made
-- from one such line and reads the numbers of others without a syntax tree. A line of another form does not fit, and is read as JSON.
-- Pure.
--
-- > numbersIn (numberTemplate "{\"x\":1}") "{\"x\":0.5}" = Just [0.5]
module Rosy.Wire.NumberTemplate
  ( NumberTemplate,
    numberTemplate,
    numbersIn,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Unsafe as Unsafe
import Data.Word (Word8)
import Foreign.C.String (CString)
import Foreign.C.Types (CDouble (..))
import Foreign.Marshal.Alloc (alloca)
import Foreign.Ptr (Ptr, minusPtr)
import Foreign.Storable (peek)
import System.IO.Unsafe (unsafeDupablePerformIO)

-- | Rounds correctly in the C library of GNU, as reading a literal in Haskell does.
foreign import ccall unsafe "strtod" c_strtod :: CString -> Ptr CString -> IO CDouble

-- | The text before the first number, between two numbers, and after the last one.
newtype NumberTemplate = NumberTemplate [ByteString]
  deriving (Eq, Show)

-- | The template of lines that are this one but for their numbers.
numberTemplate :: ByteString -> NumberTemplate
numberTemplate = NumberTemplate . pieces 0
  where
    -- From where the end of the piece is searched.
    pieces from bytes = case ByteString.findIndex isSpecial (ByteString.drop from bytes) of
      Nothing -> [bytes]
      Just i
        | ByteString.index bytes (from + i) == quote -> pieces (afterText (from + i + 1) bytes) bytes
        | otherwise -> let (piece, rest) = ByteString.splitAt (from + i) bytes in piece : pieces 0 (ByteString.dropWhile isNumeric rest)
    isSpecial byte = byte == quote || beginsNumber byte
    -- Past the end of a text.
    afterText from bytes = case ByteString.findIndex (\b -> b == quote || b == backslash) (ByteString.drop from bytes) of
      Nothing -> ByteString.length bytes
      Just i
        | ByteString.index bytes (from + i) == quote -> from + i + 1
        | otherwise -> afterText (from + i + 2) bytes
    quote = 34
    backslash = 92

-- | The numbers of a line in order; nothing when the line has another form.
numbersIn :: NumberTemplate -> ByteString -> Maybe [Double]
numbersIn (NumberTemplate texts) = go texts
  where
    go [] _ = Nothing
    go [end] bytes = if bytes == end then Just [] else Nothing
    go (piece : more) bytes = do
      (x, rest) <- ByteString.stripPrefix piece bytes >>= leadingNumber
      (x :) <$> go more rest

-- | The number at the beginning, which another byte follows, and the bytes behind it. There is no negative zero, as in JSON read by aeson.
leadingNumber :: ByteString -> Maybe (Double, ByteString)
leadingNumber bytes
  | size == 0 || size == ByteString.length bytes || not (beginsNumber (Unsafe.unsafeHead bytes)) || used /= size = Nothing
  | otherwise = Just (if x == 0 then 0 else x, Unsafe.unsafeDrop size bytes)
  where
    size = ByteString.length (ByteString.takeWhile isNumeric bytes)
    (x, used) = unsafeDupablePerformIO . Unsafe.unsafeUseAsCString bytes $ \start -> alloca $ \end -> do
      CDouble found <- c_strtod start end
      after <- peek end
      pure (found, after `minusPtr` start)

beginsNumber, isNumeric :: Word8 -> Bool
beginsNumber b = isDigit b || b == 45
isNumeric b = isDigit b || b == 45 || b == 46 || b == 43 || b == 101 || b == 69

isDigit :: Word8 -> Bool
isDigit b = b >= 48 && b <= 57
