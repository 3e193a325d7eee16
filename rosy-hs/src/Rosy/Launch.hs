{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Rosy.Launch
-- Description : Starting a program's @main@ with a robot to talk to.
--
-- Whoever runs a program (the worker's child, a native program) calls 'onPipe' with the program's @main@.
-- 'simulate' finds the link in the one process-wide variable of the library.
module Rosy.Launch
  ( -- * Launching
    onPipe,
    onLink,

    -- * What main calls
    simulate,
    simulateNamed,
  )
where

import Control.Exception
import Control.Monad (unless)
import Data.IORef
import Data.Word (Word32)
import Foreign.C.Types (CInt)
import Foreign.Ptr (Ptr)
import Rosy.Controller (Names (..))
import Rosy.Link
import Rosy.Link.Pipe (pipeLink)
import Rosy.Problem
import Rosy.Run (runOn)
import Rosy.Runnable
import System.IO (hFlush, hPutStrLn, stderr, stdout)
import System.IO.Unsafe (unsafePerformIO)

-- | What the process knows of its robot.
data Robot
  = NoRobot
  | Ready Link
  | Used

-- The one process-wide variable: 'simulate' has the type that the paper gives it, so the link cannot be an argument.
robot :: IORef Robot
robot = unsafePerformIO (newIORef NoRobot)
{-# NOINLINE robot #-}

-- | Run a controller or a task against the robot that the program was started with: the simulator or a real one.
simulate :: Runnable a => a -> IO ()
simulate = simulateNamed (Names [])

-- | 'simulate' with the names of the functions.
simulateNamed :: Runnable a => Names -> a -> IO ()
simulateNamed names what = do
  found <- atomicModifyIORef' robot (\r -> (case r of Ready _ -> Used; other -> other, r))
  case found of
    NoRobot -> hPutStrLn stderr "There is no robot here. Start this program with ./rosy run."
    Used -> throwIO RanBefore
    Ready link -> runOn link (program names what)

-- | Run a program's @main@ on a pipe to the simulator. Takes the file descriptor of a stream socket that is used in both directions,
-- and a page of 4096 bytes of shared memory, or a null pointer. In the page the program leaves the name of the function at work:
-- the first word is the length in bytes (0 when none is at work), the name follows as UTF-8 from byte 4. It is written before the
-- function starts, so whoever ends a program that is stuck finds there what it was stuck in.
--
-- Every way to end is told to the robot before this returns: zero velocity first, then how it ended.
onPipe :: CInt -> Ptr Word32 -> IO () -> IO ()
onPipe descriptor page mainOf = do
  link <- pipeLink descriptor page
  onLink link mainOf `catch` lost
  where
    -- Nobody is there any more to be told.
    lost :: Fault -> IO ()
    lost _ = pure ()

-- | Run a program's @main@ on a robot, however that is reached. Every way to end is told to it before this returns, but for a
-- robot that is lost: that is thrown as 'LinkLost'.
onLink :: Link -> IO () -> IO ()
onLink link mainOf = do
  ended <- newIORef False
  let once' answer' ending = do
        before <- atomicModifyIORef' ended (True,)
        unless before (end link answer' ending)
      link' = link {end = once'}
  writeIORef robot (Ready link')
  result <- try mainOf
  hFlush stdout
  case result of
    Right () -> once' noAnswer EndedDone
    Left exception -> case fromException exception of
      Just (LinkLost why) -> throwIO (LinkLost why)
      _ -> once' noAnswer (EndedError (problemFrom (Just "main") [] Nothing exception))
