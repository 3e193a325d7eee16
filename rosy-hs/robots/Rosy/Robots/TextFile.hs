-- |
-- Module      : Rosy.Robots.TextFile
-- Description : Bytes of a text file that a user wrote.
--
-- By the rules of the service, @sim-service/rosy_sim/files.py@.
module Rosy.Robots.TextFile
  ( decodeText,
  )
where

import qualified Data.ByteString as B
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as T
import Data.Text.Encoding (decodeUtf16BEWith, decodeUtf16LEWith, decodeUtf8')
import Data.Text.Encoding.Error (lenientDecode)

-- | UTF-8, or UTF-16 after a byte order mark, without the mark; 'Nothing' for anything else.
decodeText :: B.ByteString -> Maybe Text
decodeText bytes
  | Just rest <- B.stripPrefix (B.pack [0xFF, 0xFE]) bytes = utf16 decodeUtf16LEWith rest
  | Just rest <- B.stripPrefix (B.pack [0xFE, 0xFF]) bytes = utf16 decodeUtf16BEWith rest
  | otherwise = either (const Nothing) Just (decodeUtf8' (fromMaybe bytes (B.stripPrefix (B.pack [0xEF, 0xBB, 0xBF]) bytes)))
  where
    -- Half a character is read as U+FFFD, which is not the content of a file that was saved as a whole.
    utf16 decode rest = let text = decode lenientDecode rest in if T.any (== '\xFFFD') text then Nothing else Just text
