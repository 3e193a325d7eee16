{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Robots.LockstepState
-- Description : What a run in lockstep is given, what it remembers, and how it can end.
--
-- "Rosy.Robots.LockstepRun" runs it.
module Rosy.Robots.LockstepState
  ( -- * What a run is given
    Pace (..),
    realPace,
    defaultStepTimeout,
    Observer (..),
    SettledStep (..),
    onTerminal,

    -- * What it remembers
    Lockstep (..),
    newLockstep,
    tickSteps,

    -- * How it ends
    LockstepResult (..),
    RunEnd (..),
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.STM
import Control.Monad (when)
import Data.Aeson (Value)
import qualified Data.ByteString as B
import qualified Data.ByteString.Lazy as L
import Data.IORef
import Network.Socket (Socket)
import Rosy.Channel (Action, Message)
import Rosy.Core (Topic)
import Rosy.Robot
import Rosy.Robots.BootClock (bootSeconds)
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import Rosy.Robots.LinkRecorder (LineSource (..))
import Rosy.Robots.PipeCodec
import Rosy.Robots.Wording (tellPerson)
import Rosy.Sentence
import System.Random (randomRIO)

-- | Callbacks of a run; none of them may block.
data Observer = Observer
  { -- | messages for the program, in its own frame
    onMessages :: [Message] -> IO (),
    -- | a command of the program, before the guard
    onProgramCommand :: Action -> IO (),
    -- | a step in which functions fired, or that is observed
    onSettled :: SettledStep -> IO (),
    -- | whether the program is to tell its firings with their provenance, from the next step on
    observes :: IO Bool,
    -- | the robot is awaited, lost or back
    onNotice :: Notice -> IO (),
    -- | lines of the robot link, each with its newline
    onLines :: LineSource -> L.ByteString -> IO ()
  }

-- | A step that the program has done: what it tells of it, and its commands in their order.
data SettledStep = SettledStep StepReport [Action]

-- | For a terminal: texts of the program go to standard output, the state of the connection to standard error.
onTerminal :: Sentence -> Observer
onTerminal name =
  Observer
    { onMessages = const (pure ()),
      onProgramCommand = \case
        SayCommand (Say s) -> putStrLn s
        _ -> pure (),
      onSettled = const (pure ()),
      observes = pure False,
      onNotice = tellPerson . explainNotice name,
      onLines = \_ _ -> pure ()
    }

data LockstepResult = LockstepResult
  { runEnd :: RunEnd,
    -- | steps that the program has answered
    stepsRun :: Int,
    -- | where the robot was last, from where it started
    lastPose :: Maybe (Position, Orientation)
  }

data RunEnd
  = Finished
  | Stopped
  | -- | message and hint; the problem as the program reported it
    Failed Sentence Sentence (Maybe Value)
  | -- | it did not answer
    Stuck
  | -- | the program ended without a message
    Died
  | -- | the robot is gone, for this reason
    RobotLost Sentence
  | -- | the robot can never be driven, for this reason
    RobotRefused Sentence
  | -- | it was stopped, or its time was over, before the robot was there
    NeverRan
  deriving (Eq, Show)

-- | Sources of randomness and time of a run.
data Pace = Pace
  { -- | the random seed of this run
    newSeed :: IO Int,
    -- | seconds of a clock that runs while the computer sleeps
    timeNow :: IO Double,
    -- | the time of day, seconds
    timeOfDay :: IO Double,
    -- | waits until the next step begins
    awaitStep :: IO (),
    -- | longest time in which the program may answer a step, seconds; pauses of this computer do not count
    stepTimeout :: Double
  }

-- | Fifty steps a second from now on, with this step timeout. One that came late is not caught up with.
realPace :: Double -> IO Pace
realPace timeout = do
  due <- bootSeconds >>= newIORef
  pure
    Pace
      { newSeed = randomRIO (0, 2 ^ (31 :: Int) - 1),
        timeNow = bootSeconds,
        timeOfDay = secondsOfDay,
        awaitStep = do
          t <- bootSeconds
          -- After a pause, as before the first step, the next one is a whole step away.
          begins <- (\d -> if t - d > stepLength then t else d) <$> readIORef due
          when (begins > t) (threadDelay (ceiling ((begins - t) * 1e6)))
          writeIORef due (begins + stepLength),
        stepTimeout = timeout
      }

-- | The step timeout of the simulator, seconds (@settle@ in @sim-service/rosy_sim/config.py@): programs have a low priority, and on a
-- busy computer one may get no processor for two seconds. The base stops by itself after 0.6 s.
defaultStepTimeout :: Double
defaultStepTimeout = 5

-- | A step, seconds (protocol/README.md).
stepLength :: Double
stepLength = 0.02

-- | Steps from one tick of the default rate to the next (protocol/README.md).
tickSteps :: Int
tickSteps = 5

-- | A run: what it was started with, and what it remembers from step to step.
data Lockstep = Lockstep
  { pace :: Pace,
    observer :: Observer,
    -- | whether the run is to stop
    stopWanted :: STM Bool,
    -- | how long the program may run, seconds of the robot
    seconds :: Maybe Double,
    -- | how long a lost robot is waited for, seconds
    patience :: Double,
    guarded :: TVar Guard,
    connection :: Connection,
    socket :: Socket,
    -- | whether a run of limited time has waited long enough for its robot
    givesUp :: STM Bool,
    -- | whether the robot was there before the program started
    present :: IORef Bool,
    -- | bytes of the program behind its last whole line
    unread :: IORef B.ByteString,
    -- | topics of the program's own
    own :: IORef [Topic],
    -- | where the robot was last
    pose :: IORef (Maybe (Position, Orientation)),
    -- | when the robot was lost, and why
    lost :: IORef (Maybe (Double, Sentence)),
    -- | why the robot can never be driven
    refused :: IORef (Maybe Sentence),
    -- | when the first step began
    beganAt :: IORef Double,
    -- | commands of this step, newest first
    commands :: IORef [Action]
  }

-- | The parameters are those of 'Rosy.Robots.LockstepRun.runLockstep'.
newLockstep :: Pace -> Observer -> STM Bool -> Maybe Double -> Double -> TVar Guard -> Connection -> Socket -> IO Lockstep
newLockstep pace observer stopWanted seconds patience guarded connection socket = do
  givesUp <- maybe (pure (pure False)) (\s -> readTVar <$> registerDelay (ceiling (max s patience * 1e6))) seconds
  present <- newIORef False
  unread <- newIORef B.empty
  own <- newIORef []
  pose <- newIORef Nothing
  lost <- newIORef Nothing
  refused <- newIORef Nothing
  beganAt <- newIORef 0
  commands <- newIORef []
  pure Lockstep {..}
