-- |
-- Description : A program on a robot's link, with a test's hands on its clock and its chance.
module Test.Robots.Played (Hands (..), playing, awaiting) where

import Control.Concurrent.Async (wait, withAsync)
import Control.Concurrent.STM
import Data.IORef
import Rosy.Core (Action (..), Message (..))
import Rosy.Launch (onLink)
import Rosy.Link (Answer (..), Batch (..), Link (..), Opening (..))
import Rosy.Link.Real
import Rosy.Robot (RobotStatus (..))
import Rosy.Robots.Base
import Rosy.Robots.Guard
import System.Timeout (timeout)
import Test.Robots.Recorded (timeOf)
import Test.Tasty.HUnit (assertFailure)

-- | How far a program has come on its link: messages and ticks answered, what it wanted at each, newest first.
data Progress = Progress {answered, ticked :: Int, wanted :: [[Action]], over :: Bool}

-- | The link, with chance as it was, and somebody who looks on.
watched :: TVar Progress -> Link -> IO Link
watched progress link = do
  current <- newIORef Nothing
  let note ended actions = do
        b <- readIORef current
        atomically . modifyTVar' progress $ \p ->
          p
            { answered = answered p + maybe 0 (length . batchMessages) b,
              ticked = ticked p + maybe 0 (fromEnum . batchTick) b,
              wanted = actions : wanted p,
              over = ended
            }
  pure
    link
      { open = Opening 1 <$ open link,
        next = next link >>= \b -> b <$ writeIORef current b,
        answer = \a -> answer link a >> note False (answerActions a),
        end = \a e -> end link a e >> note True (answerActions a ++ [SetVelocity 0 0])
      }

-- | What a test does to a program on a robot.
data Hands = Hands
  { -- | what happens now happens in this step
    at :: Int -> IO (),
    -- | waits until so many more messages are answered
    answers :: Int -> IO (),
    -- | the clock ticks, and that is answered
    tick :: IO (),
    -- | what the program has wanted so far at each message or tick
    soFar :: IO [[Action]],
    isOver :: IO Bool
  }

-- | A program on a base, which may be there already. The action plays the stream. Gives all that the program wanted.
playing :: IO () -> Base -> Bool -> (Hands -> IO ()) -> IO [[Action]]
playing main' base known play = do
  time <- newTVarIO 0
  due <- newTVarIO False
  progress <- newTVarIO (Progress 0 0 [] False)
  sent <- newIORef 0
  let unknown = newGuard (Limits 0.7 pi) False
      comes f goal = awaiting (atomically (readTVar progress >>= \p -> check (f p >= goal || over p)))
  there <- newTVarIO False
  reins <- newReins (if known then snd (hearing Here unknown) else unknown)
  link <- realLink (Clock (readTVarIO time) due) 10 reins (neverLost there base) >>= watched progress
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
    stopAsked reins
    awaiting (wait running)
  soFar hands

-- | A robot that a busy machine holds up for longer than a robot may be silent is not lost here: time is in the test's hands.
neverLost :: TVar Bool -> Base -> Base
neverLost there base = base {hear = hear base >>= fmap concat . mapM kept >>= \hs -> hs <$ check (not (null hs))}
  where
    kept h = case h of
      Gone _ -> pure []
      Heard (StatusMessage Offline) -> pure []
      Heard (StatusMessage Online) -> (\again -> [h | not again]) <$> swapTVar there True
      _ -> pure [h]

awaiting :: IO () -> IO ()
awaiting act = timeout 120000000 act >>= maybe (assertFailure "the robot was not told") pure
