-- |
-- Module      : Rosy.Worker.Page
-- Description : What stands in the page of memory that a program shares with the worker.
--
-- The program writes there which function is at work ("Rosy.Link.Pipe"), and may have written anything at all. Pure: every page is a test.
module Rosy.Worker.Page
  ( wordOf,
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

-- | Bytes of a page, and the most of a text in it that anybody is shown.
pageSize, longestText :: Int
pageSize = 4096
longestText = 1024

-- | The text in a page: the first word says at which byte its length stands, 0 for no text; UTF-8 after that.
wordOf :: ByteString -> Text
wordOf page
  | place < 4 || place > ByteString.length page - 4 = Text.empty
  | otherwise = Text.filter isPrint (decodeUtf8With lenientDecode (ByteString.take (min (number place) longestText) (ByteString.drop (place + 4) page)))
  where
    place = number 0
    -- Four bytes as every machine that Rosy runs on has them: the lowest first.
    number at = foldr (\byte higher -> fromIntegral byte .|. (higher `shiftL` 8)) 0 (ByteString.unpack (ByteString.take 4 (ByteString.drop at page))) :: Int
