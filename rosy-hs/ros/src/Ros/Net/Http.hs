{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Ros.Net.Http
-- Description : As much HTTP as XML-RPC needs.
--
-- In: bytes. Out: the body of a POST, and back. A request or response has a head of lines and a body of
-- @Content-Length@ bytes (a response without a length ends with its connection). The functions that
-- read bytes do no I/O, so that every cut of a stream can be tested; "Ros.Net.Rpc" moves the bytes.
module Ros.Net.Http
  ( -- * Reading
    Parsed (..),
    Head (..),
    parseMessage,
    bodyAtEnd,
    keepsAlive,
    wantsContinue,
    maxHead,
    maxBody,

    -- * Writing
    post,
    ok,
    refusal,
  )
where

import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as B
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.Char (isSpace, toLower)
import Data.List (elemIndex)

-- | The first line, and the fields with their names in lower case.
data Head = Head {firstLine :: C.ByteString, headFields :: [(C.ByteString, C.ByteString)]}
  deriving (Eq, Show)

data Parsed
  = -- | Not all there yet; the head, if it is complete.
    More (Maybe Head)
  | -- | A whole message, and the bytes behind it.
    Whole Head B.ByteString B.ByteString
  | -- | This can not become a message that is wanted here.
    Bad String
  deriving (Eq, Show)

-- | Generous: nodes send heads of about 200 bytes.
maxHead :: Int
maxHead = 65536

-- | A parameter may hold a whole robot description; 64 MB is beyond any of them.
maxBody :: Int
maxBody = 64 * 1024 * 1024

parseMessage :: B.ByteString -> Parsed
parseMessage bytes = case splitHead bytes of
  Nothing
    | B.length bytes > maxHead -> Bad "the head is too long"
    | otherwise -> More Nothing
  Just (top, rest)
    | Just "chunked" <- lookup "transfer-encoding" (headFields top) -> dechunk top rest
    | otherwise -> case contentLength top of
      Nothing -> if "HTTP/" `B.isPrefixOf` firstLine top then More (Just top) else Whole top B.empty rest
      Just n
        | n < 0 || n > maxBody -> Bad "the body is too long"
        | B.length rest < n -> More (Just top)
        | otherwise -> let (body, behind) = B.splitAt n rest in Whole top body behind

-- | What a response without a length holds when its connection has ended.
bodyAtEnd :: B.ByteString -> Maybe (Head, B.ByteString)
bodyAtEnd = splitHead

dechunk :: Head -> B.ByteString -> Parsed
dechunk top = go []
  where
    go seen bytes = case breakLine bytes of
      Nothing -> More (Just top)
      Just (line, rest) -> case hex (C.takeWhile (\c -> c /= ';' && not (isSpace c)) line) of
        Nothing -> Bad "a chunk without a length"
        Just 0 -> case breakLine rest of
          Just (_, behind) -> Whole top (B.concat (reverse seen)) behind
          Nothing -> More (Just top)
        Just n
          | n > maxBody || sum (map B.length seen) + n > maxBody -> Bad "the body is too long"
          | B.length rest < n + 2 -> More (Just top)
          | otherwise -> go (B.take n rest : seen) (B.drop (n + 2) rest)
    hex t
      | C.null t || C.length t > 8 = Nothing
      | otherwise = C.foldl' (\acc c -> (\a d -> a * 16 + d) <$> acc <*> digit c) (Just 0) t
    digit c = elemIndex (toLower c) (['0' .. '9'] ++ ['a' .. 'f'])

-- | Up to the empty line. Lines may end without a carriage return.
splitHead :: B.ByteString -> Maybe (Head, B.ByteString)
splitHead = go []
  where
    go seen bytes = do
      (line, rest) <- breakLine bytes
      if C.null line
        then case reverse seen of
          [] -> go [] rest -- an empty line before a request is to be ignored (RFC 9112, 2.2)
          first : fs -> Just (Head first (map field fs), rest)
        else go (line : seen) rest
    field l = let (k, v) = C.break (== ':') l in (C.map toLower (C.strip k), C.strip (C.drop 1 v))

breakLine :: B.ByteString -> Maybe (B.ByteString, B.ByteString)
breakLine bytes = case C.break (== '\n') bytes of
  (_, rest) | C.null rest -> Nothing
  (line, rest) -> Just (if C.isSuffixOf "\r" line then C.init line else line, C.tail rest)

contentLength :: Head -> Maybe Int
contentLength top = lookup "content-length" (headFields top) >>= fmap fst . C.readInt

-- | HTTP/1.1 unless it says otherwise; HTTP/1.0 only when it asks.
keepsAlive :: Head -> Bool
keepsAlive top = case C.map toLower <$> lookup "connection" (headFields top) of
  Just "close" -> False
  Just "keep-alive" -> True
  _ -> not ("HTTP/1.0" `C.isSuffixOf` firstLine top)

wantsContinue :: Head -> Bool
wantsContinue top = (C.map toLower <$> lookup "expect" (headFields top)) == Just "100-continue"

post :: String -> String -> B.Builder -> L.ByteString
post host path = message ("POST " <> B.stringUtf8 path <> " HTTP/1.1\r\nHost: " <> B.stringUtf8 host <> "\r\nUser-Agent: rosy\r\nConnection: close\r\n")

ok :: Bool -> B.Builder -> L.ByteString
ok alive = message ("HTTP/1.1 200 OK\r\nServer: rosy\r\n" <> (if alive then mempty else "Connection: close\r\n"))

-- | For what is no call: browsers and port scanners.
refusal :: L.ByteString
refusal = message "HTTP/1.1 400 Bad Request\r\nConnection: close\r\n" mempty

message :: B.Builder -> B.Builder -> L.ByteString
message top body = B.toLazyByteString (top <> "Content-Type: text/xml\r\nContent-Length: " <> B.int64Dec (L.length whole) <> "\r\n\r\n") <> whole
  where
    whole = B.toLazyByteString body
