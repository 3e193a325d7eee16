-- |
-- Module      : Ros.LogLevel
-- Description : How grave a log message is, and the words that ROS has for it.
module Ros.LogLevel
  ( LogLevel (..),
    levelWord,
    readLevel,
  )
where

import Data.Char (toLower, toUpper)
import Data.List (find)

data LogLevel = Debug | Info | Warn | Error | Fatal
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | @DEBUG@
levelWord :: LogLevel -> String
levelWord = map toUpper . show

-- | In capitals or not.
readLevel :: String -> Maybe LogLevel
readLevel word = find ((== map toLower word) . map toLower . levelWord) [minBound ..]
