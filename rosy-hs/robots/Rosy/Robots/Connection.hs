{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Robots.Connection
-- Description : Connection to a real robot, independent of its transport.
--
-- Each of the three transports (rosbridge, ROS 1, serial) makes a 'Connection'. It accepts commands without blocking and
-- queues events; loss and return of the robot are events.
module Rosy.Robots.Connection
  ( Connection (..),
    resolveCommand,
    RobotEvent (..),
    EventQueue,
    newEventQueue,
    enqueue,
    awaitEvents,
    availableEvents,

    -- * Time
    secondsOfDay,

    -- * For people
    Notice (..),
    unknownReason,
    explainNotice,
  )
where

import Control.Concurrent.STM
import Control.Monad (unless)
import Data.Fixed (mod')
import Data.List (nubBy)
import qualified Data.Text as Text
import Data.Time.Clock.POSIX (getPOSIXTime)
import Rosy.Channel (Action, Channel (..), Kind (..), Message (..))
import Rosy.Codec (Route, commandTopics, readAction)
import Rosy.Core (Topic)
import Rosy.Sentence
import Rosy.Topic (pattern OpenAction)

-- | The universal time of day, seconds since midnight.
secondsOfDay :: IO Double
secondsOfDay = (`mod'` 86400) . realToFrac <$> getPOSIXTime

data Connection = Connection
  { -- | For people: @the robot at ws://pi:9090@.
    connectionName :: Sentence,
    -- | The channels that it has.
    connectionRoutes :: [Route],
    -- | Subscribes and advertises a program's own topics. Answers a sentence for each that is not possible.
    registerTopics :: [Topic] -> IO [Sentence],
    -- | Queues a command. Does not block and does not fail; a command that cannot be sent is dropped.
    sendCommand :: Action -> IO (),
    -- | All events since the last call; blocks until there is one.
    takeEvents :: STM [RobotEvent]
  }

-- | A command as it is sent. One on a topic of the program's own is the robot's own command if the robot has that topic, so that
-- it passes the guard; none if its message does not fit.
resolveCommand :: Connection -> Action -> Maybe Action
resolveCommand connection a = case a of
  OpenAction name message
    | Text.pack name `elem` commandTopics (connectionRoutes connection) -> either (const Nothing) Just (readAction (connectionRoutes connection) (Text.pack name) message)
  _ -> Just a

data RobotEvent
  = Received Message
  | -- | The odometry of the robot arrives.
    Connected
  | -- | It does not, for this reason.
    Disconnected Sentence
  | -- | It can never be driven over this connection, for this reason.
    Refused Sentence
  | -- | Its server says that something is wrong, in these words.
    Complained Sentence
  deriving (Eq, Show)

-- | Events that were not taken yet, newest first.
newtype EventQueue = EventQueue (TVar [RobotEvent])

newEventQueue :: IO EventQueue
newEventQueue = EventQueue <$> newTVarIO []

-- | Adds an event. When the queue is long, only the newest value of each state channel is kept, so that a slow program gets
-- current values. Readings of event channels are never dropped.
enqueue :: EventQueue -> RobotEvent -> STM ()
enqueue (EventQueue var) h = do
  waiting <- readTVar var
  writeTVar var $! case h of
    Received (Message c _) | isState c && length waiting > maxQueuedStates -> h : thinned waiting
    _ -> h : waiting
  where
    -- Those that came after the last event, the newest of each channel.
    thinned hs = let (states, rest) = span (any isState . channelOf) hs in nubBy (\a b -> channelOf a == channelOf b) states ++ rest
    isState c = channelKind c `elem` [StateChannel, ClockChannel]
    channelOf (Received (Message c _)) = Just c
    channelOf _ = Nothing

-- | More than the channels of a robot, so that a fifth of a second of each state at 50 Hz is kept.
maxQueuedStates :: Int
maxQueuedStates = 100

awaitEvents :: EventQueue -> STM [RobotEvent]
awaitEvents h = do
  hs <- availableEvents h
  check (not (null hs))
  pure hs

-- | All queued events; empty when there is none.
availableEvents :: EventQueue -> STM [RobotEvent]
availableEvents (EventQueue var) = do
  hs <- readTVar var
  unless (null hs) (writeTVar var [])
  pure (reverse hs)

-- | State of the connection for a person, with the reason: 'unknownReason' if there is none.
data Notice
  = IsAwaited Sentence
  | IsThere
  | IsLost Sentence
  | IsBack
  | IsRefused Sentence
  | IsComplaining Sentence
  deriving (Eq, Show)

-- | No reason is known.
unknownReason :: Sentence
unknownReason = verbatim ""

-- | A sentence about the robot of this name.
explainNotice :: Sentence -> Notice -> Sentence
explainNotice name n = case n of
  IsAwaited why
    | why == unknownReason -> trWith "waiting for {robot} (Ctrl-C gives up)" ["robot" =@ name]
    | otherwise -> trWith "waiting for {robot}: {why}" ["robot" =@ name, "why" =@ why]
  IsThere -> trWith "{robot} is there" ["robot" =@ name]
  IsLost why
    | why == unknownReason -> trWith "{robot} is lost" ["robot" =@ name]
    | otherwise -> trWith "{robot} is lost: {why}" ["robot" =@ name, "why" =@ why]
  IsBack -> trWith "{robot} is back" ["robot" =@ name]
  IsRefused why -> trWith "{robot} cannot be driven: {why}" ["robot" =@ name, "why" =@ why]
  IsComplaining what -> trWith "{robot}: its server says: {what}" ["robot" =@ name, "what" =@ what]
