-- |
-- Module      : Rosy.Robots.Guard
-- Description : What stands between a program and real wheels.
--
-- In: what the robot says, what the program wants, and the time. Out: what the program hears, and what the robot is
-- told. Pure. It keeps speeds within limits, repeats a velocity that is not zero, because the base stops when it
-- hears nothing for 0.6 s (kobuki_node: cmd_vel_timeout), forgets it when the robot is lost, lets the safety
-- rules go first, and moves odometry so that the program starts at the origin.
module Rosy.Robots.Guard
  ( -- * What it is
    Guard,
    newGuard,
    Limits (..),
    isHere,
    isEvading,

    -- * What comes
    hearing,
    commanding,
    ticking,
    halting,
    renewing,
    watching,
  )
where

import Data.Maybe (fromMaybe)
import Rosy.Core (Action (..), Message (..), Odometry (..))
import Rosy.Robot
import Rosy.Robots.Base (Heard (..))
import Rosy.Robots.Safety

-- | The fastest that a program may go: m/s and rad/s.
data Limits = Limits {maxSpeed :: !Double, maxTurn :: !Double}
  deriving (Eq, Show)

data Guard = Guard
  { limits :: !Limits,
    -- | with the safety rules, what they have noticed
    trouble :: !(Maybe Trouble),
    -- | until when the safety rules own the wheels, seconds
    ownedUntil :: !Double,
    -- | what the wheels were told last, to be repeated
    kept :: !(Double, Double),
    here :: !Bool,
    halted :: !Bool,
    -- | whether somebody watches the robot; wheels turn only then
    watched :: !Bool,
    origin :: !(Maybe Odometry)
  }

newGuard :: Limits -> Bool -> Guard
newGuard l safe = Guard l (if safe then Just noTrouble else Nothing) 0 (0, 0) False False True Nothing

isHere :: Guard -> Bool
isHere = here

-- | Whether the safety rules own the wheels.
isEvading :: Guard -> Bool
isEvading g = ownedUntil g > 0

-- | What the program is to hear of it, and what the robot is told at once: one that is lost is told to stand. Perhaps it hears that
-- at once, perhaps when it is found again, behind all that was under way to it meanwhile.
hearing :: Heard -> Guard -> (([Message], [Action]), Guard)
hearing h g = case h of
  Here -> (([], []), g {here = True})
  Gone _ -> (([StatusMessage Offline | here g], [SetVelocity 0 0 | here g]), g {here = False, kept = (0, 0)})
  Heard (OdometryMessage o) -> (([OdometryMessage (from start o)], []), g {origin = Just start})
    where
      start = fromMaybe o (origin g)
  Heard m -> (([m], []), g {trouble = notice m <$> trouble g})

-- | Odometry in the frame of where the program started.
from :: Odometry -> Odometry -> Odometry
from (Odometry (Position x0 y0) (Orientation a0) _) (Odometry (Position x y) (Orientation a) v) =
  Odometry (Position (dx * cos a0 + dy * sin a0) (dy * cos a0 - dx * sin a0)) (Orientation (wrapped (a - a0))) v
  where
    dx = x - x0
    dy = y - y0
    wrapped t
      | t > pi = t - 2 * pi
      | t <= negate pi = t + 2 * pi
      | otherwise = t

-- | What the robot is told when the program wants this, at a time in seconds.
commanding :: Double -> Action -> Guard -> ([Action], Guard)
commanding t a g = case a of
  SetVelocity v w
    | not (here g) || halted g || t < ownedUntil g -> ([], g)
    | not (watched g) -> ([], g {kept = limited})
    | otherwise -> ([uncurry SetVelocity limited], g {kept = limited})
    where
      limited = (within (maxSpeed (limits g)) v, within (maxTurn (limits g)) w)
  _ | here g -> ([a], g)
  -- What a program says is for people: it needs no robot.
  SayText _ -> ([a], g)
  _ -> ([], g)

-- | No number beyond the limit, in either direction; what is no number is zero.
within :: Double -> Double -> Double
within limit x
  | isNaN x || isInfinite x = 0
  | otherwise = max (negate limit) (min limit x)

-- | Ten times a second: what the robot is told without the program.
ticking :: Double -> Guard -> ([Action], Guard)
ticking t g
  | not (here g) || halted g || not (watched g) = ([], g)
  | Just (v, w) <- trouble g >>= evade = ([SetVelocity v w], g {ownedUntil = t + holds, kept = (0, 0)})
  | ownedUntil g > 0 && t >= ownedUntil g = ([SetVelocity 0 0], g {ownedUntil = 0})
  | kept g /= (0, 0) = ([uncurry SetVelocity (kept g)], g)
  | otherwise = ([], g)

-- | How long the safety rules own the wheels after they have spoken, seconds (safe_random_walker_app, the
-- multiplexer's timeout). Afterwards the robot stands until the program says something new.
holds :: Double
holds = 0.2

-- | The person stops the robot: whatever the program wants from now on, the wheels stand.
halting :: Guard -> ([Action], Guard)
halting g = ([SetVelocity 0 0], g {halted = True, kept = (0, 0), ownedUntil = 0})

-- | Another program begins: it starts where the robot is, may drive, and what is pressed is still pressed.
renewing :: Guard -> Guard
renewing g = g {halted = False, watched = True, kept = (0, 0), ownedUntil = 0, origin = Nothing}

-- | Whether somebody watches. Unwatched wheels stand; what the program wanted last is done again when somebody is back.
watching :: Bool -> Guard -> ([Action], Guard)
watching yes g
  | watched g == yes = ([], g)
  | yes = ([], g {watched = True})
  | otherwise = ([SetVelocity 0 0 | here g], g {watched = False, ownedUntil = 0})
