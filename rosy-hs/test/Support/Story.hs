{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Support.Story
-- Description : Telling what happens to a program, and hearing what it does.
--
-- A story is a list of timed happenings; the answer is a list of lines as a trace would show them.
module Support.Story
  ( -- * What happens
    Moment,
    at,
    sensed,
    odometryAt,
    ticked,
    still,
    moving,

    -- * What is heard
    told,
    commandsOf,
    firedIn,
    Heard (..),
    hear,
    hearProgram,
  )
where

import Control.Exception (SomeException, evaluate, try)
import Rosy.Channel (tellAction)
import Rosy.Controller (Names (..))
import Rosy.Core
import Rosy.Loop
import Rosy.Robot
import Rosy.Runnable
import System.IO.Unsafe (unsafePerformIO)
import System.Random (mkStdGen)

-- | Seconds, and what happens then.
type Moment = (Double, What)

-- | At so many seconds.
at :: Double -> What -> Moment
at = (,)

-- | A message.
sensed :: Message -> What
sensed = Hear

-- | Odometry with this velocity, at the origin.
odometryAt :: Velocity -> What
odometryAt v = Hear (OdometryMessage (Odometry (Position 0 0) (Orientation 0) v))

-- | A tick of the default rate.
ticked :: What
ticked = TickNow

-- | Odometry of a robot that stands.
still :: What
still = odometryAt (Velocity 0 0)

-- | Odometry of a robot that drives so fast.
moving :: Double -> What
moving v = odometryAt (Velocity v 0)

-- | What came out of one instant, or of the start.
data Heard = Heard
  { heardAt :: Double,
    heardFired :: [String],
    heardCommands :: [String],
    heardEvents :: [String],
    -- | What is remembered then, type and value; nothing at the end.
    heardMemory :: [(String, String)],
    heardEnd :: Maybe String
  }
  deriving (Eq, Show)

-- | All commands, each with its time.
told :: Runnable a => a -> [Moment] -> [(Double, String)]
told c moments = [(heardAt h, line) | h <- hear c moments, line <- heardCommands h]

-- | All commands.
commandsOf :: Runnable a => a -> [Moment] -> [String]
commandsOf c = map snd . told c

-- | The names of all that fired.
firedIn :: Runnable a => Names -> a -> [Moment] -> [String]
firedIn names c = concatMap heardFired . hearProgram (program names c)

-- | Run without names.
hear :: Runnable a => a -> [Moment] -> [Heard]
hear c = hearProgram (program (Names []) c)

-- | Run a program from time 0 with seed 1, instant by instant, up to its end.
hearProgram :: Program r -> [Moment] -> [Heard]
hearProgram p = go 0 [] (begin (Start 0 0 (mkStdGen 1)) p)
  where
    go time fired turn todo = case turn of
      Fires firing after -> case attempt (firingEffects firing) of
        Nothing -> go time (nameText (firingName firing) : fired) after todo
        Just failure -> closing time (("failed: " ++ failure) : nameText (firingName firing) : fired) "Failed" (firingFailed firing)
      Settled network ->
        let (report, network') = collect network
         in heard time fired report (remembered network') Nothing : case todo of
              [] -> []
              (t, what) : rest -> go t [] (instant t what network') rest
      Enters _ _ after -> go time fired after todo
      Closes outcome after -> closing time fired (show outcome) after
      Ended report -> [heard time fired report [] Nothing]
    closing time fired how = \case
      Fires firing after -> closing time (nameText (firingName firing) : fired) how (maybe after (const (firingFailed firing)) (attempt (firingEffects firing)))
      Enters _ _ after -> closing time fired how after
      Closes _ after -> closing time fired how after
      Settled network -> closing time fired how (stop network)
      Ended report -> [heard time fired report [] (Just how)]
    heard time fired report =
      Heard time (reverse fired) (map tellAction (reportActions report)) (reportEvents report)

-- | What evaluating throws.
attempt :: a -> Maybe String
attempt x = unsafePerformIO (either (Just . takeWhile (/= '\n') . show') (const Nothing) <$> try (evaluate x))
  where
    show' e = show (e :: SomeException)
