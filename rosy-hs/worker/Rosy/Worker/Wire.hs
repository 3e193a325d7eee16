{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Wire
-- Description : The lines of the worker's socket, without the socket.
--
-- Requests in, answers out, as protocol/README.md section 3 writes them; and the cutting of a stream of bytes into lines
-- of bounded length. Pure: every odd cut is a test.
module Rosy.Worker.Wire
  ( -- * Requests
    Request (..),
    Question (..),
    questionBytes,
    Id,
    parseRequest,

    -- * Answers
    Answer (..),
    answerLine,
    reportFields,
    completionFields,

    -- * Cutting a stream into lines
    Lines,
    noLines,
    Cut (..),
    cut,
    longestLine,
  )
where

import Data.Aeson (Series, Value (..), eitherDecodeStrict', encode, object, pairs, (.:), (.=))
import Data.Aeson.Encoding (int, list, pair)
import Data.Aeson.Types (Object, Parser, parseEither)
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (encodeUtf8)
import Rosy.Worker.Problem (Completion (..), Place (Place), Problem, Report (..), Span (..), Typed (..))

-- | Chosen by the service; any JSON value.
type Id = Value

data Request
  = Ask Id Question
  | -- | The source and the bytes of memory the run may take.
    Run Id Text Int
  | Kill Id
  | -- | Whether anybody is there.
    Ping Id
  deriving (Eq, Show)

-- | What a service may want to know about a text.
data Question
  = Check Text
  | Complete Text Place
  deriving (Eq, Show)

-- | A question as bytes, no two questions as the same.
questionBytes :: Question -> ByteString
questionBytes question = case question of
  Check source -> "check " <> encodeUtf8 source
  Complete source (Place l c) -> Char8.pack (unwords ["complete", show l, show c, ""]) <> encodeUtf8 source

-- | A request, or the id (null if there is none) and a sentence for @failed@.
parseRequest :: ByteString -> Either (Id, Text) Request
parseRequest line = case eitherDecodeStrict' line of
  Left _ -> Left (Null, "This line is not JSON.")
  Right (Object o) -> case parseEither (.: "id") o of
    Left _ -> Left (Null, "A request needs an id.")
    Right i -> either (\e -> Left (i, Text.pack e)) Right (parseEither (request i) o)
  Right _ -> Left (Null, "A request is a JSON object.")

request :: Id -> Object -> Parser Request
request i o = do
  op <- o .: "op"
  case op :: Text of
    "check" -> Ask i . Check <$> source
    "complete" -> (\s l c -> Ask i (Complete s (Place l c))) <$> source <*> o .: "line" <*> o .: "column"
    "run" -> Run i <$> source <*> o .: "memory"
    "kill" -> pure (Kill i)
    "ping" -> pure (Ping i)
    other -> fail ("There is no request called " ++ show other ++ ".")
  where
    source = do
      text <- o .: "source"
      if Text.length text > longestSource
        then fail ("The source is longer than " ++ show longestSource ++ " characters.")
        else pure text

-- | Characters. protocol/README.md, section 3.
longestSource :: Int
longestSource = 200000

-- | What the worker says. The fields of a report arrive from a child as they are to be sent.
data Answer
  = ReadyNow Text
  | -- | To a question.
    Known Question Id ByteString
  | Started Id ByteString
  | Refused Id ByteString
  | -- | How it ended, the function at work, a problem of the worker's own.
    GoneNow Id (Either Int Int) (Maybe Text) (Maybe Problem)
  | Pong Id
  | Failed Id Text

answerLine :: Answer -> ByteString
answerLine answer = case answer of
  ReadyNow version -> whole [op "ready", "protocol" .= (1 :: Int), "ghc" .= version]
  Known (Check _) i fields -> spliced [op "checked", "id" .= i] fields
  Known (Complete _ _) i fields -> spliced [op "completed", "id" .= i] fields
  Started i fields -> spliced [op "started", "id" .= i] fields
  Refused i fields -> spliced [op "refused", "id" .= i] fields
  GoneNow i how firing problem ->
    whole $
      [op "gone", "id" .= i, either ("exit" .=) ("signal" .=) how]
        ++ maybe [] (\f -> ["firing" .= f]) firing
        ++ maybe [] (\p -> ["problem" .= p]) problem
  Pong i -> whole [op "pong", "id" .= i]
  Failed i message -> whole [op "failed", "id" .= i, "message" .= message]
  where
    op name = "op" .= (name :: Text)
    whole members = Lazy.toStrict (encode (object members)) <> "\n"
    -- Fields are a JSON object of at least one member.
    spliced members fields = ByteString.init (Lazy.toStrict (encode (object members))) <> "," <> ByteString.drop 1 fields <> "\n"

-- | The members of @checked@ besides @id@, as an object in bytes.
reportFields :: Report -> Series
reportFields report =
  "problems" .= problems report
    <> "declarations" .= declarations report
    <> pair "graph" (pairs ("functions" .= functions report))
    <> pair "types" (pairs ("names" .= Map.keys names <> pair "at" (list place (types report))))
  where
    -- Each type is written once; a place is five numbers.
    names = Map.fromDistinctAscList (zip (Set.toAscList (Set.fromList (map hasType (types report)))) [0 :: Int ..])
    place (Typed (Span (Place l c) (Place l' c')) t) = list int [l, c, l', c', names Map.! t]

-- | The members of @completed@ besides @id@.
completionFields :: Completion -> Series
completionFields completion = maybe mempty ("expected" .=) (expected completion) <> "names" .= offered completion

-- | What has arrived of a line that is not complete, or how much of a line that is too long has gone by.
data Lines = Lines [ByteString] !Int | Skipping
  deriving (Eq, Show)

noLines :: Lines
noLines = Lines [] 0

data Cut = Line ByteString | TooLong
  deriving (Eq, Show)

-- | Bytes. A source of the greatest length with every character escaped is some 2.4 million.
longestLine :: Int
longestLine = 4000000

-- | The lines that some bytes complete. A line that is too long is reported once, when it passes the limit, and the rest
-- of it is thrown away.
cut :: Lines -> ByteString -> ([Cut], Lines)
cut state bytes = case (state, Char8.elemIndex '\n' bytes) of
  (Skipping, Nothing) -> ([], Skipping)
  (Skipping, Just n) -> cut noLines (ByteString.drop (n + 1) bytes)
  (Lines parts size, Nothing)
    | size + ByteString.length bytes > longestLine -> ([TooLong], Skipping)
    | ByteString.null bytes -> ([], state)
    | otherwise -> ([], Lines (bytes : parts) (size + ByteString.length bytes))
  (Lines parts size, Just n)
    | size + n > longestLine -> prepend TooLong (cut noLines rest)
    | otherwise -> prepend (Line (ByteString.concat (reverse (ByteString.take n bytes : parts)))) (cut noLines rest)
    where
      rest = ByteString.drop (n + 1) bytes
  where
    prepend x (xs, s) = (x : xs, s)
