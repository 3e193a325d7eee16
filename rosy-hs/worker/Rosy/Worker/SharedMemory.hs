-- |
-- Module      : Rosy.Worker.SharedMemory
-- Description : Decoder of the memory page that a running program shares with the worker.
--
-- The program writes the name of the active function there ("Rosy.Link.Pipe"). The content is not trusted. Pure.
module Rosy.Worker.SharedMemory
  ( activeFunctionName,
    pageSize,
  )
where

import Data.Bits (shiftL, (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import Data.Char (isPrint)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8With)
import Data.Text.Encoding.Error (lenientDecode)

-- | Size of the page, and the longest text that is read from it, in bytes.
pageSize, longestText :: Int
pageSize = 4096
longestText = 1024

-- | The text in a page. The first word is the offset of its length, or 0 for no text; UTF-8 follows the length.
activeFunctionName :: ByteString -> Text
activeFunctionName page
  | offset < 4 || offset > ByteString.length page - 4 = Text.empty
  | otherwise = Text.filter isPrint (decodeUtf8With lenientDecode (ByteString.take (min (number offset) longestText) (ByteString.drop (offset + 4) page)))
  where
    offset = number 0
    -- Little-endian, the byte order of all supported machines.
    number at = foldr (\byte higher -> fromIntegral byte .|. (higher `shiftL` 8)) 0 (ByteString.unpack (ByteString.take 4 (ByteString.drop at page))) :: Int
