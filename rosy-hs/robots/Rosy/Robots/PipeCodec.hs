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
    stopLine,
    ProgramLine (..),
    readProgramLine,
  )
where

import Data.Aeson (Object, Value (..), (.!=), (.:), (.:?))
import qualified Data.Aeson as Aeson
import Data.Aeson.Encoding (fromEncoding, text, value)
import Data.Aeson.Types (Parser, parseMaybe)
import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder, doubleDec, intDec)
import Data.Either (fromRight)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Channel (Action, Message (..))
import Rosy.Codec
import Rosy.Core (Topic (..), TopicUse (..))
import Rosy.Topic (pattern OpenAction, pattern OpenMessage)
import Rosy.Wire (pipeRoutes)

-- | The first line, with the seed and the time of day at the start (s).
startLine :: Int -> Double -> Builder
startLine seed clock = "{\"op\":\"start\",\"protocol\":1,\"seed\":" <> intDec seed <> ",\"clock\":" <> doubleDec clock <> ",\"trace\":false}\n"

stopLine :: Builder
stopLine = "{\"op\":\"stop\"}\n"

-- | The messages of a step, and its number and time.
batchLines :: Int -> Double -> [Message] -> Builder
batchLines step time messages =
  foldMap sensorLine messages <> "{\"op\":\"step\",\"step\":" <> intDec step <> ",\"time\":" <> doubleDec time <> "}\n"

-- | A message on a topic of the program's own that is also the simulated robot's travels once, in the robot's message.
sensorLine :: Message -> Builder
sensorLine (OpenMessage name message)
  | Text.pack name `elem` map routeTopic (sensorRoutes pipeRoutes) = mempty
  | otherwise = "{\"op\":\"publish\",\"topic\":" <> fromEncoding (text (Text.pack name)) <> ",\"msg\":" <> fromEncoding (value message) <> "}\n"
sensorLine (Message c fields) = case routeFor pipeRoutes c of
  Just route -> "{\"op\":\"publish\",\"topic\":" <> fromEncoding (text (routeTopic route)) <> ",\"msg\":" <> fromEncoding (encode route fields) <> "}\n"
  -- A robot may sense what the simulated one does not have.
  Nothing -> mempty

-- | A line of a program.
data ProgramLine
  = Commands Action
  | Ready
  | -- | It has done all that this step makes it do; these functions fired, and sent so many of the step's commands each. Without
    -- counts one function sent all of them.
    Settled [Text] [Int]
  | -- | It has ended: @done@, @stopped@ or @error@, with what a person should know, what to do, and all of the problem.
    HasEnded Text (Maybe (Text, Text, Value))
  | -- | It names one of its topics.
    DeclaresTopic Topic
  deriving (Eq, Show)

-- | Nothing for a line that protocol/README.md does not have.
readProgramLine :: ByteString -> Maybe ProgramLine
readProgramLine bytes = case Aeson.decodeStrict' bytes of
  Just (Object o) -> parseMaybe programLine o
  _ -> Nothing

programLine :: Object -> Parser ProgramLine
programLine o = do
  op <- o .: "op"
  case op :: Text of
    "publish" -> fmap Commands (wanted <$> o .: "topic" <*> o .: "msg")
    "settled" -> Settled <$> o .:? "fired" .!= [] <*> o .:? "sent" .!= []
    "ready" -> pure Ready
    "advertise" -> DeclaresTopic <$> named Sent
    "subscribe" -> DeclaresTopic <$> named Taken
    "ended" -> do
      problem <- o .:? "problem"
      HasEnded <$> o .: "how" <*> traverse (\p -> (,,) <$> p .: "message" <*> p .:? "hint" .!= "" <*> pure (Object p)) problem
    _ -> fail "unknown op"
  where
    -- What the simulated robot does not have may be another robot's, or the program's own.
    wanted topic msg = fromRight (OpenAction (Text.unpack topic) msg) (readAction pipeRoutes topic msg)
    named use = (\name kind -> Topic name kind use) <$> o .: "topic" <*> o .:? "type" .!= ""
