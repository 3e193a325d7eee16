{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.UnreadableMessages
-- Description : Messages of a robot that cannot be read, counted for each topic.
--
-- In: the topic of a message and why it cannot be read. Out: a sentence for the first one of a topic, and at the end how many there were. Pure.
module Rosy.Robots.UnreadableMessages
  ( Unreadable (..),
    UnreadableCounts,
    noneUnreadable,
    countUnreadable,
    unreadableSentences,
  )
where

import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as T
import Rosy.Sentence

-- | A message that cannot be read: its topic, which is empty when not even that can be read, and why.
data Unreadable = Unreadable Text Text
  deriving (Eq, Show)

-- | How many there were, by topic.
newtype UnreadableCounts = UnreadableCounts (Map.Map Text Int)

noneUnreadable :: UnreadableCounts
noneUnreadable = UnreadableCounts Map.empty

-- | One more. The sentence is for a person, once for each topic.
countUnreadable :: Unreadable -> UnreadableCounts -> (Maybe Sentence, UnreadableCounts)
countUnreadable (Unreadable topic why) (UnreadableCounts counts) = (if Map.member topic counts then Nothing else Just first, UnreadableCounts (Map.insertWith (+) topic 1 counts))
  where
    first
      | T.null topic = trWith "a message of its server cannot be read: {why}" ["why" =: why]
      | otherwise = trWith "a message on {topic} cannot be read: {why}" ["topic" =: topic, "why" =: why]

-- | For the end of a run: how many messages of each topic could not be read.
unreadableSentences :: UnreadableCounts -> [Sentence]
unreadableSentences (UnreadableCounts counts) = map said (Map.toList counts)
  where
    said (topic, n)
      | T.null topic = trWith "Messages of the robot's server that could not be read: {count}." ["count" =: T.pack (show n)]
      | otherwise = trWith "Messages on {topic} that could not be read: {count}." ["topic" =: topic, "count" =: T.pack (show n)]
