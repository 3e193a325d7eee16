{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Rosy.Launch
-- Description : Starting a program's @main@ with a robot to talk to.
--
-- A runner of programs (the worker's child, a native program) calls 'onPipe' with the program's @main@.
-- 'simulate' finds the link in the one process-wide variable of the library.
module Rosy.Launch
  ( -- * Launching
    onPipe,
    onLink,

    -- * What main calls
    simulate,
    simulateNamed,
    withTopics,
    simulateTask,

    -- * Worlds
    simulateIn,
    World,
    world1,
    world2,
    world3,
    world4,
  )
where

import Control.Exception
import Control.Monad (unless)
import Data.IORef
import Data.List (nub)
import Data.Word (Word32)
import Foreign.C.Types (CInt)
import Foreign.Ptr (Ptr)
import Rosy.BranchCoverage (Branch, setBranches)
import Rosy.Console (printingTo, sayingAll, withCapturedOutput)
import Rosy.Controller (Names (..))
import Rosy.Core (Task, Topic)
import Rosy.Link
import Rosy.Link.Mailbox (Mailbox)
import Rosy.Link.Pipe (pipeLink)
import Rosy.Problem
import Rosy.Run (runOn)
import Rosy.Runnable
import Rosy.Wire (branchText)
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

-- The topics of the program's own sensors and commands, which are known before it runs.
topicsOfProgram :: IORef [Topic]
topicsOfProgram = unsafePerformIO (newIORef [])
{-# NOINLINE topicsOfProgram #-}

-- | A program that connects types of its own to these topics.
withTopics :: [[Topic]] -> IO a -> IO a
withTopics topics mainOf = writeIORef topicsOfProgram (nub (concat topics)) >> mainOf

-- | Run a controller or a task against the robot that the program was started with: the simulator or a real one.
simulate :: Runnable a => a -> IO ()
simulate = simulateNamed (Names [])

-- | Run a task. The same as 'simulate', by its name of 2019.
simulateTask :: Task end -> IO ()
simulateTask = simulate

-- | A world of the original simulator, by name.
newtype World = World String
  deriving (Eq, Show)

-- | The worlds of the original simulator. See 'simulateIn'.
world1, world2, world3, world4 :: World
world1 = World "world1"
world2 = World "world2"
world3 = World "world3"
world4 = World "world4"

-- | Run a controller. Programs of 2019 and 2021 chose a world; here the room is chosen in the page or with @--world@, so that one program
-- runs in many rooms and on real robots. The world is ignored.
simulateIn :: Runnable a => World -> a -> IO ()
simulateIn _ = simulate

-- | 'simulate' with the names of the functions.
simulateNamed :: Runnable a => Names -> a -> IO ()
simulateNamed names what = do
  found <- atomicModifyIORef' robot (\r -> (case r of Ready _ -> Used; other -> other, r))
  case found of
    NoRobot -> hPutStrLn stderr "There is no robot here. Start this program with ./rosy run."
    Used -> throwIO RanBefore
    Ready link -> readIORef topicsOfProgram >>= \topics -> runOn link topics (program names what)

-- | Run a program's @main@ on a pipe to the simulator. Takes the file descriptor of a stream socket that is used in both directions,
-- and a page of 4096 bytes of shared memory, or a null pointer. In the page the program leaves the name of the function at work:
-- the first word is the length in bytes (0 when none is at work), the name follows as UTF-8 from byte 4. It is written before the
-- function starts, so that the function a program is stuck in can be named when it is ended.
--
-- A mailbox, if there is one, takes the place of the link for the bytes of a step.
--
-- Takes the empty places of the program as well, so that a run that comes to one can say so, and its branches, so that firings tell which they took.
--
-- Every way to end is told to the robot before this returns: zero velocity first, then how it ended. What the program prints, the robot says,
-- also what it prints after @simulate@: the robot is told of the end when @main@ has ended.
onPipe :: CInt -> Ptr Word32 -> Mailbox -> [EmptyPlace] -> [Branch] -> IO () -> IO ()
onPipe descriptor page mailbox places branches mainOf = do
  setBranches branchText branches
  link <- placing <$> pipeLink descriptor page mailbox
  withCapturedOutput (\printed -> launch (AfterMain printed) (printingTo printed link) mainOf `catch` lost)
  where
    placing link = link {end = \told ending -> end link told (case ending of EndedError problem -> EndedError (atEmptyPlace places problem); other -> other)}
    -- No peer is left to be told.
    lost :: Fault -> IO ()
    lost _ = pure ()

-- | Run a program's @main@ on a robot, however that is reached. Every way to end is told to it before this returns, but for a
-- robot that is lost: that is thrown as 'LinkLost'.
onLink :: Link -> IO () -> IO ()
onLink = launch AtOnce

-- | When a robot is told that a run has ended well: when @simulate@ returns, or after the rest of @main@, whose output this action
-- takes.
data EndTold = AtOnce | AfterMain (IO [String])

-- | Of several ends the first is told.
launch :: EndTold -> Link -> IO () -> IO ()
launch told link mainOf = do
  ended <- newIORef False
  kept <- newIORef (noAnswer, EndedDone)
  let once' answer' ending = do
        before <- atomicModifyIORef' ended (True,)
        unless before (end link answer' ending)
      endOfRun answer' ending = case (told, ending) of
        (AfterMain printed, EndedDone) -> keep printed answer' ending
        (AfterMain printed, EndedStopped) -> keep printed answer' ending
        _ -> once' answer' ending
      keep printed answer' ending = printed >>= \texts -> writeIORef kept (answer' {answerActions = sayingAll texts ++ answerActions answer'}, ending)
  writeIORef robot (Ready link {end = endOfRun})
  result <- try mainOf
  hFlush stdout
  (answer', ending) <- readIORef kept
  texts <- case told of
    AfterMain printed -> printed
    AtOnce -> pure []
  let lastAnswer = answer' {answerActions = answerActions answer' ++ sayingAll texts}
  case result of
    Right () -> once' lastAnswer ending
    Left exception -> case fromException exception of
      Just (LinkLost why) -> throwIO (LinkLost why)
      _ -> once' lastAnswer (EndedError (problemFrom (Just "main") [] Nothing exception))
