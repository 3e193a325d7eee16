{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.JsonOfServers
-- Description : JSON in which @NaN@, @Infinity@ and @-Infinity@ may stand for numbers.
--
-- Pure. rosbridge_suite writes them so, because Python's json does (RobotWebTools/rosbridge_suite, issue 916). They are read as "Rosy.JsonNumber" has them.
module Rosy.Robots.JsonOfServers
  ( readJson,
  )
where

import Data.Aeson (Value)
import qualified Data.Aeson as Aeson
import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L

-- | The value of a text, or what is wrong with it.
readJson :: L.ByteString -> Either String Value
readJson bytes = case Aeson.eitherDecode bytes of
  Right v -> Right v
  -- Only a text with such a word is read twice.
  Left why
    | any (`B.isInfixOf` strict) ["NaN", "Infinity"] -> either (const (Left why)) Right (Aeson.eitherDecode (withoutWords strict))
    | otherwise -> Left why
  where
    strict = L.toStrict bytes

-- | The text with JSON in the place of these words, wherever they stand outside of strings.
withoutWords :: ByteString -> L.ByteString
withoutWords = Builder.toLazyByteString . outside ','
  where
    -- The character is the one before.
    outside before b = case C.break (`elem` ("\"NI" :: String)) b of
      (plain, rest) -> Builder.byteString plain <> special (if B.null plain then before else C.last plain) rest
    special before b = case C.uncons b of
      Nothing -> mempty
      Just ('"', rest) -> Builder.char7 '"' <> string rest
      Just (c, rest)
        | Just more <- B.stripPrefix "NaN" b, standsAlone before more -> "\"NaN\"" <> outside '"' more
        | Just more <- B.stripPrefix "Infinity" b, standsAlone before more -> "1e999" <> outside '9' more
        | otherwise -> Builder.char7 c <> outside c rest
    string b = case C.break (`elem` ("\"\\" :: String)) b of
      (plain, rest) ->
        Builder.byteString plain <> case C.uncons rest of
          Nothing -> mempty
          Just ('"', more) -> Builder.char7 '"' <> outside '"' more
          -- A backslash and what it escapes.
          Just _ -> Builder.byteString (B.take 2 rest) <> string (B.drop 2 rest)
    standsAlone before more = before `elem` ("[,:- \t\r\n" :: String) && maybe True ((`elem` ("],} \t\r\n" :: String)) . fst) (C.uncons more)
