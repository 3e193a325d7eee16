-- |
-- Module      : Rosy.Robots.Drive
-- Description : A program's main on a real robot.
--
-- In: which robot, and the program. Out: an exit status; what a person should know is on standard error. However it
-- ends, the robot is told to stop first: when the program is done, fails or is stopped, on Ctrl-C and on the
-- system's request. A program that does not listen any more is ended a second after that.
module Rosy.Robots.Drive
  ( drive,
    driveFor,
    later,
    withBase,
    onSignals,
    endings,
  )
where

import Control.Concurrent (forkIO, myThreadId, threadDelay)
import Control.Exception
import Control.Monad (unless, void)
import Data.IORef
import Ros.Names (readArguments)
import Ros.Node (Settings (..))
import Rosy.Launch (onLink)
import Rosy.Link
import Rosy.Link.Real
import Rosy.Link.Ros
import Rosy.Link.Rosbridge
import Rosy.Link.Serial
import Rosy.Problem
import Rosy.Robots.Announce (announced)
import Rosy.Robots.Base
import Rosy.Robots.Guard
import Rosy.Robots.Target
import System.Environment (getEnvironment)
import System.Exit
import System.IO (BufferMode (..), hPutStrLn, hSetBuffering, stderr, stdout)
import System.Posix.Process (exitImmediately)
import System.Posix.Signals (Handler (..), Signal, installHandler, sigHUP, sigINT, sigTERM, sigUSR1)

-- | The robot that an address means, while an action runs.
withBase :: Target -> (Base -> IO a) -> IO a
withBase target use = case targetWay target of
  Rosbridge host port path -> withRosbridge host port path (targetProfile target) use
  Serial device -> withSerial device use
  Ros1 host port -> do
    environment' <- getEnvironment
    let at = "http://" ++ host ++ ":" ++ show port
        settings = Settings (readArguments []) (("ROS_MASTER_URI", at) : filter ((/= "ROS_MASTER_URI") . fst) environment') "rosy"
    withRos settings ("the robot at ros://" ++ host ++ ":" ++ show port) (targetProfile target) use

-- | Drives a robot with a program's @main@.
drive :: Target -> IO () -> IO ExitCode
drive = driveFor Nothing

-- | 'drive', for so many seconds at most.
driveFor :: Maybe Double -> Target -> IO () -> IO ExitCode
driveFor seconds target program = announced (targetAddress target) $ do
  mapM_ (`hSetBuffering` LineBuffering) [stdout, stderr]
  ended <- newIORef EndedDone
  r <- newReins (newGuard (targetLimits target) (targetSafety target))
  main' <- myThreadId
  result <- try . withClock $ \clock -> withBase target $ \base -> do
    let stopping = do
          halt r base
          stopAsked r
          void . forkIO $ do
            threadDelay patienceWithProgram
            throwTo main' UserInterrupt
            -- Code that allocates nothing cannot be interrupted.
            threadDelay patienceWithProgram
            exitImmediately (ExitFailure 2)
    mapM_ (`later` stopping) seconds
    link <- realLink clock (targetPatience target) r base
    onSignals endings stopping (onLink link {end = \as e -> writeIORef ended e >> end link as e} program)
      `finally` halt r base
  how <- readIORef ended
  case result of
    Left e -> ExitFailure 2 <$ told (problemFrom Nothing [] Nothing e)
    Right () -> case how of
      EndedError p -> ExitFailure 2 <$ told p
      _ -> pure ExitSuccess
  where
    told p = do
      hPutStrLn stderr (problemMessage p)
      unless (null (problemHint p)) (hPutStrLn stderr (problemHint p))

-- | A second, in microseconds: what a program that was asked to stop may still take (protocol/README.md, stop).
patienceWithProgram :: Int
patienceWithProgram = 1000000

-- | In so many seconds. A thread's delay is counted in an Int of microseconds: a week fits.
later :: Double -> IO () -> IO ()
later seconds = void . forkIO . (threadDelay (ceiling (seconds * 1e6)) >>)

-- | The signals that mean that a program is to end. The last is the emergency stop of @./rosy estop@.
endings :: [Signal]
endings = [sigINT, sigTERM, sigHUP, sigUSR1]

-- | The first of these signals stops in good order. The handlers are put back afterwards.
onSignals :: [Signal] -> IO () -> IO a -> IO a
onSignals signals act body = bracket (mapM install signals) (mapM_ restore) (const body)
  where
    install s = (,) s <$> installHandler s (CatchOnce act) Nothing
    restore (s, old) = installHandler s old Nothing
