-- |
-- Description : A program on a robot's link, with a test's hands on its clock and its chance.
module Test.Robots.Played (Hands (..), playing, awaiting) where

import Control.Concurrent.Async (wait, withAsync)
import Control.Concurrent.STM
import Data.IORef
import Rosy.Channel (Action)
import Rosy.Launch (onLink)
import Rosy.Link (Answer (..), Batch (..), Link (..), Opening (..))
import Rosy.Link.Real
import Rosy.Robot
import Rosy.Robots.Connection
import Rosy.Robots.Guard
import System.Timeout (timeout)
import Test.Robots.Recorded (isTold, timeOf)
import Test.Tasty.HUnit (assertFailure)

-- | How far a program has come on its link: messages and ticks answered, what it wanted at each, newest first.
data Progress = Progress {answered, ticked :: Int, wanted :: [[Action]], over :: Bool}

-- | The link, with chance as it was, watched all the time.
watched :: TVar Progress -> Link -> IO Link
watched progress link = do
  current <- newIORef Nothing
  let note ended actions = do
        b <- readIORef current
        atomically . modifyTVar' progress $ \p ->
          p
            { answered = answered p + maybe 0 (length . filter isTold . batchMessages) b,
              ticked = ticked p + maybe 0 (fromEnum . batchTick) b,
              wanted = actions : wanted p,
              over = ended
            }
  pure
    link
      { open = fmap (const (Opening 1 0)) . open link,
        next = next link >>= \b -> b <$ writeIORef current b,
        answer = \a -> answer link a >> note False (answerActions a),
        end = \a e -> end link a e >> note True (answerActions a ++ [VelocityCommand (Velocity 0 0)])
      }

-- | What a test does to a program on a robot.
data Hands = Hands
  { -- | what happens now happens in this step
    at :: Int -> IO (),
    -- | waits until so many more messages are answered, not counting those that only packets have
    answers :: Int -> IO (),
    -- | the clock ticks, and that is answered
    tick :: IO (),
    -- | what the program has wanted so far at each message or tick
    soFar :: IO [[Action]],
    isOver :: IO Bool
  }

-- | A program on a base, which may be there already. The action plays the stream. Gives all that the program wanted.
playing :: IO () -> Connection -> Bool -> (Hands -> IO ()) -> IO [[Action]]
playing main' base known play = do
  time <- newTVarIO 0
  due <- newTVarIO False
  progress <- newTVarIO (Progress 0 0 [] False)
  sent <- newIORef 0
  let unknown = newGuard (Limits 0.7 pi (Just (Wheels 0.7 0.23))) False
      comes f goal = awaiting (atomically (readTVar progress >>= \p -> check (f p >= goal || over p)))
  there <- newTVarIO False
  reins <- newRunControl (if known then snd (onEvent Connected unknown) else unknown)
  link <- realLink (Clock (readTVarIO time) (pure 0) (pure ()) due) 10 reins (neverLost there base) >>= watched progress
  let hands =
        Hands
          { at = atomically . writeTVar time . timeOf,
            answers = \n -> atomicModifyIORef' sent (\k -> (k + n, k + n)) >>= comes answered,
            tick = readTVarIO progress >>= \p -> atomically (writeTVar due True) >> comes ticked (ticked p + 1),
            soFar = reverse . wanted <$> readTVarIO progress,
            isOver = over <$> readTVarIO progress
          }
  withAsync (onLink link main') $ \running -> do
    play hands
    requestStop reins
    awaiting (wait running)
  soFar hands

-- | A robot that a busy machine holds up for longer than a robot may be silent is not lost here, and no command is too old: time is in the test's hands.
neverLost :: TVar Bool -> Connection -> Connection
neverLost there base = base {sendCommand = \_ -> sendCommand base endOfTime, takeEvents = takeEvents base >>= fmap concat . mapM kept >>= \hs -> hs <$ check (not (null hs))}
  where
    -- Later than any time of the system's clock, seconds.
    endOfTime = 1e12
    kept h = case h of
      Disconnected _ -> pure []
      Received (RobotStatusMessage Offline) -> pure []
      Received (RobotStatusMessage Online) -> (\again -> [h | not again]) <$> swapTVar there True
      _ -> pure [h]

awaiting :: IO () -> IO ()
awaiting act = timeout 120000000 act >>= maybe (assertFailure "the robot was not told") pure
