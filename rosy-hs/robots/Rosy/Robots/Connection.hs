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
    sendNow,
    RobotEvent (..),
    withoutEvents,
    EventQueue,
    newEventQueue,
    enqueue,
    awaitEvents,
    availableEvents,
    enqueueUnreadable,
    unreadableSoFar,

    -- * Time
    secondsOfDay,

    -- * For people
    Notice (..),
    unknownReason,
    explainNotice,
    stillness,
    motionNotice,
    neverRan,
    mayNotDrive,
  )
where

import Control.Concurrent.STM
import Control.Monad (unless)
import Data.Aeson (Value)
import Data.Fixed (mod')
import Data.List (nubBy)
import qualified Data.Text as Text
import Data.Time.Clock.POSIX (getPOSIXTime)
import Rosy.Channel (Action, Channel (..), Kind (..), Message (..))
import Rosy.Codec (Route, commandTopics, readAction)
import Rosy.Core (Topic)
import Rosy.Robot (pattern RobotStatusMessage)
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.UnreadableMessages
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
    -- | Queues a command that was decided at this time, seconds of 'bootSeconds'. Does not block and does not fail; a command that cannot be sent is
    -- dropped, and a movement that is too old when it is written is sent as zero velocity ("Rosy.Robots.Expiry").
    sendCommand :: Double -> Action -> IO (),
    -- | Takes back the goals of actions that are under way.
    cancelGoals :: IO (),
    -- | Answers a call of an action or service with a reason instead of carrying it out.
    refuseCall :: Value -> Text.Text -> IO (),
    -- | All events since the last call; blocks until there is one.
    takeEvents :: STM [RobotEvent],
    -- | Of the robot's messages, those that could not be read.
    unreadableMessages :: STM UnreadableCounts,
    -- | The topic to which velocities are sent, and its type; none on a serial line.
    velocityTopic :: STM (Maybe (Text.Text, Text.Text))
  }

-- | A command as it is sent. One on a topic of the program's own is the robot's own command if the robot has that topic, so that
-- it passes the guard; none if its message does not fit.
resolveCommand :: Connection -> Action -> Maybe Action
resolveCommand connection a = case a of
  OpenAction name message
    | Text.pack name `elem` commandTopics (connectionRoutes connection) -> either (const Nothing) Just (readAction (connectionRoutes connection) (Text.pack name) message)
  _ -> Just a

-- | Sends the commands of a decision that is made now. The time is read before: a process may be suspended in between.
sendNow :: Connection -> STM [Action] -> IO ()
sendNow connection decide = do
  t <- bootSeconds
  atomically decide >>= mapM_ (sendCommand connection t)

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
  | -- | A message of it cannot be read; the first of its topic.
    Misunderstood Sentence
  deriving (Eq, Show)

-- | The messages without those of events: what happened before a program started is not for it (rule R10).
-- Whether the robot is on line stays, which every run begins with, in the simulator too.
withoutEvents :: [Message] -> [Message]
withoutEvents = filter $ \case
  RobotStatusMessage _ -> True
  Message c _ -> channelKind c /= EventChannel

-- | Events that were not taken yet, newest first, and the messages that were none.
data EventQueue = EventQueue (TVar [RobotEvent]) (TVar UnreadableCounts)

newEventQueue :: IO EventQueue
newEventQueue = EventQueue <$> newTVarIO [] <*> newTVarIO noneUnreadable

-- | Counts a message that cannot be read; the first of its topic is an event.
enqueueUnreadable :: EventQueue -> Unreadable -> STM ()
enqueueUnreadable h@(EventQueue _ counts) u = stateTVar counts (countUnreadable u) >>= mapM_ (enqueue h . Misunderstood)

unreadableSoFar :: EventQueue -> STM UnreadableCounts
unreadableSoFar (EventQueue _ counts) = readTVar counts

-- | Adds an event. When the queue is long, only the newest value of each state channel is kept, so that a slow program gets
-- current values. Readings of event channels are never dropped.
enqueue :: EventQueue -> RobotEvent -> STM ()
enqueue (EventQueue var _) h = do
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
availableEvents (EventQueue var _) = do
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
  | IsUnreadable Sentence
  | -- | It is told to drive and does not move; topic and type of its velocities.
    IsStill (Maybe (Text.Text, Text.Text))
  | -- | It moves again.
    IsMoving
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
  IsUnreadable what -> trWith "{robot}: {what}" ["robot" =@ name, "what" =@ what]
  IsComplaining what -> trWith "{robot}: its server says: {what}" ["robot" =@ name, "what" =@ what]
  IsStill topic -> trWith "{robot}: {what}" ["robot" =@ name, "what" =@ stillness topic]
  IsMoving -> trWith "{robot} moves" ["robot" =@ name]

-- | What a robot does that is told to drive and does not move, and the likely causes.
stillness :: Maybe (Text.Text, Text.Text) -> Sentence
stillness topic = case topic of
  Nothing -> tr "it has been told to drive for a second and does not move. Is something holding it, or are its motors off?"
  Just (name, kind) -> trWith "it has been told to drive for a second and does not move. Is something holding it, are its motors off or its emergency stop pressed, does another program drive it, or does it not listen to {type} on {topic}?" ["type" =: kind, "topic" =: name]

-- | Why an action is not begun, or a service not called.
mayNotDrive :: Text.Text
mayNotDrive = "the robot may not drive now: it is stopped, lost, or held by the safety rules"

-- | Why a run did nothing.
neverRan :: Sentence
neverRan = tr "The program never ran, because the robot was not there."

-- | Tells of a robot that begins or ceases to stand although it is told to drive.
motionNotice :: Connection -> Bool -> IO Notice
motionNotice connection moves = if moves then pure IsMoving else IsStill <$> atomically (velocityTopic connection)
