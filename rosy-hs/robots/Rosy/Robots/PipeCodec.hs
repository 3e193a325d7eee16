{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Robots.PipeCodec
-- Description : Codec of the simulator's side of the robot link.
--
-- In: what a robot senses; lines from a program. Out: lines for the program; its commands. Pure; the lines are
-- those of @protocol/README.md@ section 2; "Rosy.Wire" is the codec of the program's side.
module Rosy.Robots.PipeCodec
  ( startLine,
    batchLines,
    StepQuestions (..),
    noQuestions,
    stopLine,
    commandLine,
    ProgramLine (..),
    StepReport (..),
    readProgramLine,
  )
where

import Data.Aeson (Object, Value (..), (.!=), (.:), (.:?))
import qualified Data.Aeson as Aeson
import Data.Aeson.Encoding (fromEncoding, text, value)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (Parser, parseMaybe)
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import Data.ByteString.Builder (Builder, doubleDec, intDec)
import Data.Either (fromRight)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Channel (Action (..), Message (..))
import Rosy.Codec
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Request (readRequest, pattern ReplyMessage, pattern RequestAction)
import Rosy.Sentence (Sentence, verbatim)
import Rosy.Topic (pattern OpenAction, pattern OpenMessage)
import Rosy.Wire (pipeRoutes)

-- | The first line, with the seed and the time of day at the start (s).
startLine :: Int -> Double -> Builder
startLine seed clock = "{\"op\":\"start\",\"protocol\":1,\"seed\":" <> intDec seed <> ",\"clock\":" <> doubleDec clock <> ",\"trace\":false}\n"

stopLine :: Builder
stopLine = "{\"op\":\"stop\"}\n"

-- | What a program is to tell of a step besides its commands: what it remembers, and its firings with their provenance.
data StepQuestions = StepQuestions {asksMemory :: Bool, asksFirings :: Bool}

noQuestions :: StepQuestions
noQuestions = StepQuestions False False

-- | The messages of a step, its number and time, and what is asked about it.
batchLines :: StepQuestions -> Int -> Double -> [Message] -> Builder
batchLines (StepQuestions memory firings) step time messages =
  foldMap sensorLine messages <> "{\"op\":\"step\",\"step\":" <> intDec step <> ",\"time\":" <> doubleDec time
    <> (if memory then ",\"memory\":true" else mempty)
    <> (if firings then ",\"firings\":true" else mempty)
    <> "}\n"

-- | A message on a topic of the program's own that is also the simulated robot's travels once, in the robot's message.
sensorLine :: Message -> Builder
sensorLine (OpenMessage name message)
  | Text.pack name `elem` map routeTopic (sensorRoutes pipeRoutes) = mempty
  | otherwise = publication (Text.pack name) (fromEncoding (value message))
sensorLine (ReplyMessage frame) = fromEncoding (value frame) <> "\n"
sensorLine (Message c fields) = case routeFor pipeRoutes c of
  Just route -> publication (routeTopic route) (fromEncoding (encode route fields))
  -- A robot may sense what the simulated one does not have.
  Nothing -> mempty

-- | A command as a program writes it; none for one that the simulated robot does not have.
commandLine :: Action -> Maybe Builder
commandLine a = case a of
  OpenAction name message -> Just (publication (Text.pack name) (fromEncoding (value message)))
  RequestAction frame -> Just (fromEncoding (value frame) <> "\n")
  Action c fields -> (\route -> publication (routeTopic route) (fromEncoding (encode route fields))) <$> routeFor (commandRoutes pipeRoutes) c

publication :: Text -> Builder -> Builder
publication topic message = "{\"op\":\"publish\",\"topic\":" <> fromEncoding (text topic) <> ",\"msg\":" <> message <> "}\n"

-- | A line of a program.
data ProgramLine
  = Commands Action
  | Ready
  | -- | It has done all that this step makes it do.
    Settled StepReport
  | -- | It has ended in this step: @done@, @stopped@ or @error@, with what a person should know, what to do, and all of the problem.
    HasEnded Text (Maybe (Sentence, Sentence, Value)) StepReport
  | -- | It names one of its topics.
    DeclaresTopic Topic
  deriving (Eq, Show)

-- | What a program tells of a step.
data StepReport = StepReport
  { reportFired :: [Text],
    -- | How many of the step's commands each of these functions sent. Without counts one function sent all of them.
    reportSent :: [Int],
    -- | Of an observed step: the fields @firings@, @sensed@ and @memory@, as they are.
    reportObserved :: Maybe Value
  }
  deriving (Eq, Show)

-- | Longest line of a program whose observations are passed on, bytes. A choice of ours: the values of a step have at most 50,000
-- characters, and a service takes lines of a million bytes.
longestObserved :: Int
longestObserved = 600000

-- | Nothing for a line that protocol/README.md does not have.
readProgramLine :: ByteString -> Maybe ProgramLine
readProgramLine bytes = case Aeson.decodeStrict' bytes of
  Just (Object o) -> parseMaybe (programLine (ByteString.length bytes <= longestObserved)) o
  _ -> Nothing

-- | With the observations of the step, or without.
programLine :: Bool -> Object -> Parser ProgramLine
programLine observes o = do
  op <- o .: "op"
  case op :: Text of
    "publish" -> fmap Commands (wanted <$> o .: "topic" <*> o .: "msg")
    "settled" -> Settled <$> report
    _ | Just _ <- readRequest (Object o) -> pure (Commands (RequestAction (Object o)))
    "ready" -> pure Ready
    "advertise" -> DeclaresTopic <$> named Sent
    "subscribe" -> DeclaresTopic <$> named Taken
    "ended" -> do
      problem <- o .:? "problem"
      HasEnded <$> o .: "how" <*> traverse (\p -> (,,) <$> said "message" p <*> said "hint" p <*> pure (Object p)) problem <*> report
    _ -> fail "unknown op"
  where
    -- What the simulated robot does not have may be another robot's, or the program's own.
    wanted topic msg = fromRight (OpenAction (Text.unpack topic) msg) (readAction pipeRoutes topic msg)
    -- A sentence of a problem, or its English text when it has no other (protocol/README.md, section 1).
    said name p = do
      text' <- p .:? name .!= ""
      sentences <- p .:? "sentences" .!= mempty
      fromMaybe (verbatim text') <$> sentences .:? name
    report = StepReport <$> o .:? "fired" .!= [] <*> o .:? "sent" .!= [] <*> pure observed
    observed
      | observes && KeyMap.member "firings" o = Just (Object (KeyMap.filterWithKey (\key _ -> key `elem` ["firings", "sensed", "memory"]) o))
      | otherwise = Nothing
    named use = (\name kind -> Topic name kind use) <$> o .: "topic" <*> o .:? "type" .!= ""
