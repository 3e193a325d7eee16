{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Network
-- Description : The network that is measured, as a learner writes it, and Rosy's loop driven through it.
--
-- Four functions: a memory that bumps set, a speed that depends on it, a sound at each bump, a counter at the default rate.
module Network
  ( Stimulus (..),
    stimuli,
    what,
    network,
    Tally (..),
    runRosy,
  )
where

import Control.Exception (evaluate)
import Rosy
import Rosy.Channel (Action, Message)
import Rosy.Loop
import Rosy.Program (Names (..))
import Rosy.Robot
import Rosy.Runnable (program)
import System.Random (mkStdGen)

-- | All four.
network :: (Bumper -> Memory Bool, Memory Bool -> Velocity -> Velocity, Bumper -> Maybe Sound, () -> Memory Int -> Memory Int)
network = (hit, accelerate, play, count)

hit :: Bumper -> Memory Bool
hit (Bumper _ s) = Memory (s == Pressed)

accelerate :: Memory Bool -> Velocity -> Velocity
accelerate (Memory backwards) (Velocity v w)
  | backwards = Velocity (v - 0.5) w
  | otherwise = Velocity (v + 0.5) w

play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = Just ErrorSound
play _ = Nothing

count :: () -> Memory Int -> Memory Int
count () (Memory n) = Memory (n + 1)

-- | What happens to both networks.
data Stimulus = Odom !Double | Bump !Bool | Ticked

-- | So many instants: in ten, seven odometry messages, two bumper events and a tick.
stimuli :: Int -> [Stimulus]
stimuli n = [stimulus k | k <- [1 .. n]]
  where
    stimulus k = case k `mod` 10 of
      0 -> Ticked
      4 -> Bump True
      8 -> Bump False
      _ -> Odom (fromIntegral (k `mod` 7))

-- | The stimulus as Rosy's loop hears it.
what :: Stimulus -> What
what s = case s of
  Odom v -> Hear (OdometryMessage (Odometry (Position 0 0) (Orientation 0) (Velocity v 0)))
  Bump pressed -> Hear (BumperMessage (Bumper CenterBumper (if pressed then Pressed else Released)))
  Ticked -> TickNow

-- | What came out: speeds, their sum, and sounds. Equal for equal networks.
data Tally = Tally {speeds :: !Int, total :: !Double, sounds :: !Int}
  deriving (Eq, Show)

-- | Drive Rosy's loop; gives the number of firings as well.
runRosy :: [Stimulus] -> IO (Int, Tally)
runRosy = go 0 (Tally 0 0 0) (begin (Start 0 0 (mkStdGen 1)) (program (Names []) network))
  where
    go :: Int -> Tally -> Turn -> [Stimulus] -> IO (Int, Tally)
    go !firings !tally turn todo = case turn of
      Fires firing after -> do
        _ <- evaluate (firingEffects firing)
        go (firings + 1) tally after todo
      Settled now ->
        let (report, now') = collect now
            tally' = foldl add tally (reportActions report)
         in case todo of
              [] -> pure (firings, tally')
              s : rest -> go firings tally' (instant 0 (what s) now') rest
      Enters _ _ after -> go firings tally after todo
      Closes _ after -> go firings tally after todo
      Ended _ -> pure (firings, tally)
    add t action = case action of
      VelocityCommand (Velocity v _) -> t {speeds = speeds t + 1, total = total t + v}
      SoundCommand _ -> t {sounds = sounds t + 1}
      _ -> t
