-- |
-- Module      : Rosy.Robots.Base
-- Description : A real robot, as those see it who neither know nor care how it is reached.
--
-- The three ways to a robot (rosbridge, ROS 1, serial) each make a 'Base'. It takes commands without waiting and
-- says what it hears; losing and finding the robot again are things that it says.
module Rosy.Robots.Base
  ( Base (..),
    Heard (..),
    Hearing,
    newHearing,
    heard,
    hearAll,
    hearNow,
    patiently,

    -- * For people
    Notice (..),
    explainNotice,
  )
where

import Control.Concurrent.STM
import Control.Monad (unless)
import Rosy.Core (Action, Message (..))
import System.Timeout (timeout)

data Base = Base
  { -- | For people: @the robot at ws://pi:9090@.
    baseName :: String,
    -- | Hand over a command. Does not wait and does not fail; what cannot be sent is forgotten.
    tell :: Action -> IO (),
    -- | All that has come since the last time; waits for something.
    hear :: STM [Heard]
  }

data Heard
  = Heard Message
  | -- | The robot is there and its odometry arrives.
    Here
  | -- | It is not, for this reason.
    Gone String
  deriving (Eq, Show)

-- | What has come and was not taken yet, newest first.
newtype Hearing = Hearing (TVar [Heard])

newHearing :: IO Hearing
newHearing = Hearing <$> newTVarIO []

-- | Odometry that a slow program has not taken is thinned out, so that it hears what is, not what was; nothing
-- else is ever left out.
heard :: Hearing -> Heard -> STM ()
heard (Hearing var) h = do
  waiting <- readTVar var
  writeTVar var $! case h of
    Heard (OdometryMessage _) | length waiting > crowded -> h : thinned waiting
    _ -> h : waiting
  where
    thinned hs = let (old, rest) = span isOdometry hs in take 1 old ++ rest
    isOdometry (Heard (OdometryMessage _)) = True
    isOdometry _ = False

-- | A fifth of a second of odometry at 50 Hz.
crowded :: Int
crowded = 10

hearAll :: Hearing -> STM [Heard]
hearAll h = do
  hs <- hearNow h
  check (not (null hs))
  pure hs

-- | Perhaps nothing.
hearNow :: Hearing -> STM [Heard]
hearNow (Hearing var) = do
  hs <- readTVar var
  unless (null hs) (writeTVar var [])
  pure (reverse hs)

-- | Nothing when it does not come for so long, microseconds. The time is counted in slices: however long this computer itself stands
-- still, as a busy or a sleeping one does, one slice passes, and what has come meanwhile is taken in the next.
patiently :: Int -> IO a -> IO (Maybe a)
patiently limit act = go slices
  where
    slices = 10 :: Int
    go 0 = pure Nothing
    go left = timeout (limit `div` slices) act >>= maybe (go (left - 1)) (pure . Just)

-- | What a person wants to know of the way to the robot; the text is the reason, if one is known.
data Notice
  = IsAwaited String
  | IsThere
  | IsLost String
  | IsBack
  deriving (Eq, Show)

-- | A sentence about the robot of this name.
explainNotice :: String -> Notice -> String
explainNotice name n = case n of
  IsAwaited "" -> "waiting for " ++ name ++ " (Ctrl-C gives up)"
  IsAwaited why -> "waiting for " ++ name ++ because why
  IsThere -> name ++ " is there"
  IsLost why -> name ++ " is lost" ++ because why
  IsBack -> name ++ " is back"
  where
    because why = if null why then "" else ": " ++ why
