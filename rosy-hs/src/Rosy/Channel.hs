{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE TypeFamilies #-}

-- |
-- Module      : Rosy.Channel
-- Description : Channels of a robot: the untyped form in which sensor messages and commands travel.
--
-- A channel is one kind of sensor message or command. Its values are a short list of fields: the leaves of the
-- Haskell type, in order, as plain numbers and texts. "Rosy.Robot" defines the channels and their types and is generated from
-- @protocol/robots@; this module knows no robot. A code of a choice is the number that the robot's messages use.
module Rosy.Channel
  ( -- * Channels
    Channel (..),
    Kind (..),
    channel,

    -- * What travels on them
    Field (..),
    Message (..),
    Action (..),
    tellMessage,
    tellAction,

    -- * Types as fields
    Packed (..),
    typed,
    fromFields,
    packNumbers,
    unpackNumbers,
  )
where

import qualified Data.Aeson as Aeson
import Data.Maybe (fromMaybe)
import Rosy.Value (Value, shown)

-- | One kind of sensor message or command.
data Channel = Channel
  { -- | Unique among the channels of all robots; smaller than 'Rosy.Core.channelLimit'.
    channelNumber :: !Int,
    -- | The name of its Haskell type.
    channelName :: String,
    channelKind :: !Kind,
    -- | How many sensors or outputs share the channel; the first field says which. 0 when it is one.
    channelPlaces :: !Int,
    -- | For a command that lasts until the task that sent it ends (rule R10): the values with which it has no effect.
    channelRest :: !(Maybe [Field]),
    -- | The value as Haskell shows it; nothing when the fields do not fit the type.
    channelShow :: [Field] -> Maybe String
  }

instance Eq Channel where
  a == b = channelNumber a == channelNumber b

instance Show Channel where
  show = channelName

-- | How a program notices a channel (rules R1 to R5).
data Kind
  = -- | Each message triggers.
    EventChannel
  | -- | Each message replaces the current value.
    StateChannel
  | -- | A state whose messages trigger the functions that take only states: odometry.
    ClockChannel
  | -- | Sent by programs.
    CommandChannel
  deriving (Eq, Show)

-- | A leaf of a value; the whole message on a topic of the program's own ("Rosy.Topic").
data Field = Number !Double | Whole !Int | Text String | Structure !Aeson.Value
  deriving (Eq, Show)

-- | A sensor message.
data Message = Message !Channel ![Field]
  deriving (Eq, Show)

-- | A command.
data Action = Action !Channel ![Field]
  deriving (Eq, Show)

-- | A message as Haskell shows it.
tellMessage :: Message -> String
tellMessage (Message c fields) = fromMaybe "_" (channelShow c fields)

-- | A command as Haskell shows it: @Velocity 0.5 0.0@.
tellAction :: Action -> String
tellAction (Action c fields) = fromMaybe "_" (channelShow c fields)

-- | Types that are a list of fields.
--
-- > unpack (pack x ++ rest) = Just (x, rest)
class Packed a where
  -- | The leaves of a value.
  pack :: a -> [Field]

  -- | The value that the first fields are, and the other fields.
  unpack :: [Field] -> Maybe (a, [Field])

instance Packed Double where
  pack x = [Number x]
  unpack (Number x : rest) = Just (x, rest)
  unpack _ = Nothing

instance Packed Int where
  pack n = [Whole n]
  unpack (Whole n : rest) = Just (n, rest)
  unpack _ = Nothing

-- | 0 and 1.
instance Packed Bool where
  pack b = [Whole (fromEnum b)]
  unpack (Whole 0 : rest) = Just (False, rest)
  unpack (Whole 1 : rest) = Just (True, rest)
  unpack _ = Nothing

-- | Text.
instance c ~ Char => Packed [c] where
  pack t = [Text t]
  unpack (Text t : rest) = Just (t, rest)
  unpack _ = Nothing

-- | A list of numbers, which is the last part of its value.
packNumbers :: [Double] -> [Field]
packNumbers = map Number

-- | The list that all these fields are.
unpackNumbers :: [Field] -> Maybe ([Double], [Field])
unpackNumbers fields = do
  numbers <- mapM number fields
  Just (numbers, [])
  where
    number field = case field of
      Number x -> Just x
      _ -> Nothing

-- | The value that these fields are, and no more.
fromFields :: Packed a => [Field] -> Maybe a
fromFields fields = case unpack fields of
  Just (x, []) -> Just x
  _ -> Nothing

-- | The value of a message or command if it is of this channel.
typed :: Packed a => Channel -> Channel -> [Field] -> Maybe a
typed wanted c fields
  | wanted == c = fromFields fields
  | otherwise = Nothing

-- | The channel of a type. The first argument is only there for its type.
channel :: (Packed a, Value a) => (a -> a) -> Int -> String -> Kind -> Int -> Maybe [Field] -> Channel
channel like number name kind places rest = Channel number name kind places rest (fmap (shown . like) . fromFields)
