{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Protocol
-- Description : Messages of the worker's socket and their encoding.
--
-- Requests and answers as defined in protocol/README.md, section 3, and a line buffer with bounded line length. Pure.
module Rosy.Worker.Protocol
  ( -- * Requests
    Request (..),
    Order (..),
    orderLine,
    Question (..),
    questionBytes,
    Id,
    parseRequest,

    -- * Answers
    Answer (..),
    answerLine,
    reportFields,
    branchFields,
    completionFields,

    -- * Cutting a stream into lines
    LineBuffer,
    emptyLineBuffer,
    BufferedLine (..),
    splitLines,
    maxLineBytes,
  )
where

import Data.Aeson (Series, Value (..), eitherDecodeStrict', encode, object, pairs, (.!=), (.:), (.:?), (.=))
import Data.Aeson.Encoding (int, list, pair)
import Data.Aeson.Types (Object, Parser, parseEither)
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (encodeUtf8)
import Rosy.Worker.Branch (Branch)
import Rosy.Worker.Problem (Completion (..), Position (Position), Problem, Span (..), Typed (..))
import Rosy.Worker.Report (Report (..))

-- | Chosen by the service; any JSON value.
type Id = Value

data Request
  = Ask Id Question
  | -- | The link rides along, or has come with 'Prepare'.
    Run Id Order
  | -- | Compile for a run that may come: as 'Run'.
    Prepare Id Order
  | -- | Serve another socket in a forked worker.
    Fork Id
  | Kill Id
  | -- | Liveness probe.
    Ping Id
  deriving (Eq, Show)

-- | A program to run.
data Order = Order
  { orderSource :: Text,
    -- | Bytes of memory that the run may take.
    orderMemory :: Int,
    -- | Whether only what it commands is wanted: neither warnings, nor the types that it uses, nor its branches.
    isPlain :: Bool
  }
  deriving (Eq, Show)

-- | A request for this run, as a line that 'parseRequest' reads. Its id is of no consequence.
orderLine :: Order -> ByteString
orderLine (Order source memory plain) = Lazy.toStrict (encode (object ["op" .= ("run" :: Text), "id" .= Null, "source" .= source, "memory" .= memory, "plain" .= plain])) <> "\n"

-- | A question about a program.
data Question
  = Check Text
  | Complete Text Position
  deriving (Eq, Show)

-- | Injective encoding of a question, used as cache key.
questionBytes :: Question -> ByteString
questionBytes question = case question of
  Check source -> "check " <> encodeUtf8 source
  Complete source (Position l c) -> Char8.pack (unwords ["complete", show l, show c, ""]) <> encodeUtf8 source

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
    "complete" -> (\s l c -> Ask i (Complete s (Position l c))) <$> source <*> o .: "line" <*> o .: "column"
    "run" -> Run i <$> order
    "prepare" -> Prepare i <$> order
    "fork" -> pure (Fork i)
    "kill" -> pure (Kill i)
    "ping" -> pure (Ping i)
    other -> fail ("There is no request called " ++ show other ++ ".")
  where
    order = Order <$> source <*> o .: "memory" <*> o .:? "plain" .!= False
    -- A byte order mark belongs to the file, not to the program: columns count without it.
    source = do
      text <- (\given -> fromMaybe given (Text.stripPrefix "\xFEFF" given)) <$> o .: "source"
      if Text.length text > maxSourceLength
        then fail ("The source is longer than " ++ show maxSourceLength ++ " characters.")
        else pure text

-- | Characters. protocol/README.md, section 3.
maxSourceLength :: Int
maxSourceLength = 200000

-- | Answers. The fields of a report come from a child in their final encoding.
data Answer
  = Ready Text
  | -- | Answer to a question.
    QuestionAnswered Question Id ByteString
  | Started Id ByteString
  | Refused Id ByteString
  | -- | Process id of a forked worker.
    Forked Id Int
  | -- | Exit code or signal, active function, and a problem reported by the worker.
    RunEnded Id (Either Int Int) (Maybe Text) (Maybe Problem)
  | Pong Id
  | Failed Id Text

answerLine :: Answer -> ByteString
answerLine answer = case answer of
  Ready version -> whole [op "ready", "protocol" .= (1 :: Int), "ghc" .= version]
  QuestionAnswered (Check _) i fields -> spliced [op "checked", "id" .= i] fields
  QuestionAnswered (Complete _ _) i fields -> spliced [op "completed", "id" .= i] fields
  Started i fields -> spliced [op "started", "id" .= i] fields
  Refused i fields -> spliced [op "refused", "id" .= i] fields
  Forked i pid -> whole [op "forked", "id" .= i, "pid" .= pid]
  RunEnded i how firing problem ->
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
    <> pair "graph" (pairs ("functions" .= functions report <> "parts" .= parts report <> "topics" .= topics report))
    <> pair "types" (pairs ("names" .= Map.keys names <> pair "at" (list place (types report))))
    <> maybe mempty (pair "groups" . list int . placesOfGroups) (groups report)
  where
    -- Each type is written once; a position in the list is five numbers.
    names = Map.fromDistinctAscList (zip (Set.toAscList (Set.fromList (map hasType (types report)))) [0 :: Int ..])
    place (Typed (Span (Position l c) (Position l' c')) t) = list int [l, c, l', c', names Map.! t]

-- | Four numbers for each span: lines since the start of the span before, column, lines to the end, column of the end.
placesOfGroups :: [Span] -> [Int]
placesOfGroups spans = concat (zipWith numbers (1 : [l | Span (Position l _) _ <- spans]) spans)
  where
    numbers before (Span (Position l c) (Position l' c')) = [l - before, c, l' - l, c']

-- | The branches of a program as a member of @started@; none when it has none.
branchFields :: [Branch] -> Series
branchFields branches = if null branches then mempty else pair "branches" (list branch branches)
  where
    branch (begin, finish, definitions, kind, number, shownText) =
      pairs ("in" .= definitions <> "kind" .= kind <> "number" .= number <> "text" .= shownText <> "start" .= at begin <> "end" .= at finish)
    at = uncurry Position

-- | The members of @completed@ besides @id@.
completionFields :: Completion -> Series
completionFields completion = maybe mempty ("expected" .=) (expected completion) <> "names" .= offered completion

-- | The incomplete line received so far, or the state of skipping a line that is too long.
data LineBuffer = LineBuffer [ByteString] !Int | Skipping
  deriving (Eq, Show)

emptyLineBuffer :: LineBuffer
emptyLineBuffer = LineBuffer [] 0

data BufferedLine = Line ByteString | TooLong
  deriving (Eq, Show)

-- | Bytes. A source of maximal length with every character escaped takes about 2.4 million.
maxLineBytes :: Int
maxLineBytes = 4000000

-- | The lines completed by some bytes. A line that is too long is reported once, when it passes the limit; its rest is discarded.
splitLines :: LineBuffer -> ByteString -> ([BufferedLine], LineBuffer)
splitLines state bytes = case (state, Char8.elemIndex '\n' bytes) of
  (Skipping, Nothing) -> ([], Skipping)
  (Skipping, Just n) -> splitLines emptyLineBuffer (ByteString.drop (n + 1) bytes)
  (LineBuffer parts size, Nothing)
    | size + ByteString.length bytes > maxLineBytes -> ([TooLong], Skipping)
    | ByteString.null bytes -> ([], state)
    | otherwise -> ([], LineBuffer (bytes : parts) (size + ByteString.length bytes))
  (LineBuffer parts size, Just n)
    | size + n > maxLineBytes -> prepend TooLong (splitLines emptyLineBuffer rest)
    | otherwise -> prepend (Line (ByteString.concat (reverse (ByteString.take n bytes : parts)))) (splitLines emptyLineBuffer rest)
    where
      rest = ByteString.drop (n + 1) bytes
  where
    prepend x (xs, s) = (x : xs, s)
