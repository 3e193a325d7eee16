{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Robots.Guard
-- Description : Speed limits, repetition and safety rules between a program and the wheels.
--
-- In: messages of the robot, commands of the program, and the time. Out: messages for the program, and commands for the
-- robot. Pure. Speeds are kept within limits. A velocity other than zero is repeated (rule R9), because the base stops
-- without a command for 0.6 s (kobuki_node: cmd_vel_timeout); it is forgotten when the robot is lost, and a robot that was lost stands until a
-- person lets it drive again ('arm'), and so does one whose program, computer or owner was away ('longestAbsence'). While the safety rules are on, they override the program. Odometry is moved so that the program starts at the origin (rule R22).
--
-- @sim-service/rosy_sim/run/steps/velocity_guard.py@ does the same for the simulator; @protocol/goldens/safety.jsonl@ holds the two together.
module Rosy.Robots.Guard
  ( -- * What it is
    Guard,
    newGuard,
    withoutRearming,
    Limits (..),
    Wheels (..),
    withinWheels,
    isConnected,
    isArmed,
    isEvading,
    mayBeDriven,
    callsServer,
    isSafe,

    -- * Events
    onEvent,
    onCommand,
    onTick,
    haltWheels,
    arm,
    disarm,
    longestAbsence,
    freshMessages,
    startRun,
    setWatched,
    setSafetyRules,
    noticeMotion,
  )
where

import Data.Aeson (Value)
import Data.Maybe (fromMaybe)
import Rosy.Channel (Action, Message)
import Rosy.Request (Request (..), readRequest, pattern RequestAction)
import Rosy.Robot
import Rosy.Robots.Connection (RobotEvent (..), withoutEvents)
import Rosy.Robots.Safety

-- | The fastest that a program may go: m/s and rad/s, and what the wheels can do, if that is documented.
data Limits = Limits {maxSpeed :: !Double, maxTurn :: !Double, wheelLimit :: !(Maybe Wheels)}
  deriving (Eq, Show)

-- | The highest speed of a wheel, m/s, and the distance between the wheels, m.
data Wheels = Wheels {wheelSpeed :: !Double, wheelbase :: !Double}
  deriving (Eq, Show)

-- | Speed and turn scaled together so that the outer wheel stays within its limit: the robot is slower on the same curve. If
-- only one of them were cut, the curve would be another.
withinWheels :: Wheels -> (Double, Double) -> (Double, Double)
withinWheels (Wheels most base) (v, w)
  | outer > most + rounding = (v * (most / outer), w * (most / outer))
  | otherwise = (v, w)
  where
    outer = abs v + abs w * base / 2
    -- A velocity at the limit stays as it is, m/s.
    rounding = 1e-9

data Guard = Guard
  { limits :: !Limits,
    -- | whether the safety rules are on
    safe :: !Bool,
    -- | sensors that touch something, also while the safety rules are off
    hazards :: !Hazards,
    -- | until when the safety rules own the wheels, seconds; 0 while they do not
    ownedUntil :: !Double,
    -- | the latest velocity of the program, to be repeated
    kept :: !(Double, Double),
    connected :: !Bool,
    halted :: !Bool,
    -- | whether the robot is watched; wheels turn only then
    watched :: !Bool,
    -- | whether a lost robot stands until it is armed
    rearms :: !Bool,
    -- | whether the robot may drive; a robot that was lost may not
    armed :: !Bool,
    origin :: !(Maybe Odometry),
    -- | when the program or its link last did something, seconds; nothing before it has
    activeAt :: !(Maybe Double),
    -- | until when events are those from before the program or its link came back from an absence, seconds
    staleUntil :: !Double,
    -- | the latest odometry, as the robot tells it
    odometry :: !(Maybe Odometry),
    -- | since when the robot has been told to drive without a change of its odometry, seconds, and the odometry since then
    drivenSince :: !(Maybe (Double, Odometry)),
    -- | whether a person was told that it does not move
    toldStill :: !Bool
  }

newGuard :: Limits -> Bool -> Guard
newGuard l yes = Guard l yes noHazards 0 (0, 0) False False True True True Nothing Nothing 0 Nothing Nothing False

-- | A robot that was lost drives on as soon as it is back and the program says so.
withoutRearming :: Guard -> Guard
withoutRearming g = g {rearms = False, armed = True}

isConnected :: Guard -> Bool
isConnected = connected

-- | Whether the robot may drive. After it was lost it may not until 'arm' or 'startRun'.
isArmed :: Guard -> Bool
isArmed = armed

-- | Lets a robot that was lost drive again.
arm :: Guard -> Guard
arm g = g {armed = True}

-- | Makes the robot stand until 'arm' or 'startRun', as if it had been lost.
disarm :: Guard -> Guard
disarm g
  | rearms g = g {armed = False, kept = (0, 0), ownedUntil = 0}
  | otherwise = g

-- | The longest time that a program, its computer or its owner may be away, seconds; then the robot stands until a person agrees. A tenth less
-- than that after which a guardian ('Rosy.Robots.Guardian.heartbeatTimeout') and the base (kobuki_node: cmd_vel_timeout) stop it, so that what they have stopped does not go on.
longestAbsence :: Double
longestAbsence = 0.5

-- | The guard after a time in which nothing was done: frozen, asleep, or with a function that hung. A stop for the robot if that was too long.
afterAbsence :: Double -> Guard -> ([Action], Guard)
afterAbsence t g
  | isBack && armed g && connected g && not (halted g) = ([driveAt 0 0], disarm now)
  | otherwise = ([], now)
  where
    isBack = rearms g && maybe False (\before -> t - before > longestAbsence) (activeAt g)
    now = g {activeAt = Just t, staleUntil = if isBack then t + longestAbsence else staleUntil g}

-- | With the commands for the robot after such a time.
withAbsence :: Double -> (Guard -> ([Action], Guard)) -> Guard -> ([Action], Guard)
withAbsence t act g = (before ++ actions, after)
  where
    (before, here) = afterAbsence t g
    (actions, after) = act here

-- | The messages of a step for the program, which begins at this time, and commands for the robot. After an absence events do not reach the
-- program for as long again: what was queued meanwhile, here or by the system, arrives within that, and a stale press is worse than a lost one (rule R10).
freshMessages :: Double -> [Message] -> Guard -> (([Message], [Action]), Guard)
freshMessages t ms g = ((if t < staleUntil after then withoutEvents ms else ms, actions), after)
  where
    (actions, after) = afterAbsence t g

-- | Whether commands of the program move the robot: it is there, no person or rule holds its wheels.
mayBeDriven :: Guard -> Bool
mayBeDriven g = connected g && not (halted g) && armed g && not (isEvading g)

-- | Whether a command calls an action or a service, which a robot that may not drive does not do. A goal may always be taken back.
callsServer :: Action -> Maybe Value
callsServer a = case a of
  RequestAction frame | Just request <- readRequest frame -> case request of
    CancelGoal _ _ -> Nothing
    _ -> Just frame
  _ -> Nothing

-- | Whether the safety rules own the wheels.
isEvading :: Guard -> Bool
isEvading g = ownedUntil g > 0

-- | Whether the safety rules are on.
isSafe :: Guard -> Bool
isSafe = safe

-- | Messages for the program and commands for the robot after an event. A lost robot is sent a stop, which may reach it
-- at once or when it is connected again, behind all commands that were under way.
onEvent :: RobotEvent -> Guard -> (([Message], [Action]), Guard)
onEvent h g = case h of
  Connected -> (([], []), g {connected = True})
  Disconnected _ -> lost
  Refused _ -> lost
  Complained _ -> (([], []), g)
  Misunderstood _ -> (([], []), g)
  Received (OdometryMessage o) -> (([OdometryMessage (from start o)], []), g {origin = Just start, odometry = Just o})
    where
      start = fromMaybe o (origin g)
  Received m -> (([m], []), g {hazards = updateHazards m (hazards g)})
  where
    lost
      | connected g = (([RobotStatusMessage Offline], [VelocityCommand (Velocity 0 0)]), g {connected = False, kept = (0, 0), ownedUntil = 0, armed = not (rearms g)})
      | otherwise = (([], []), g)

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

-- | Commands for the robot after a command of the program, at a time in seconds.
onCommand :: Double -> Action -> Guard -> ([Action], Guard)
onCommand t a = withAbsence t $ \g -> case a of
  VelocityCommand (Velocity v w)
    | not (connected g) || halted g || not (armed g) -> ([], g)
    | not (watched g) || t < ownedUntil g -> ([], g {kept = limited})
    | otherwise -> ([uncurry driveAt limited], g {kept = limited})
    where
      limited = maybe id withinWheels (wheelLimit (limits g)) (within (maxSpeed (limits g)) v, within (maxTurn (limits g)) w)
  _ | connected g -> ([a], g)
  -- A text of a program is for people: it needs no robot.
  SayCommand (Say _) -> ([a], g)
  _ -> ([], g)

-- | A velocity as a command.
driveAt :: Double -> Double -> Action
driveAt v w = VelocityCommand (Velocity v w)

-- | No number beyond the limit, in either direction; what is no number is zero.
within :: Double -> Double -> Double
within limit x
  | isNaN x || isInfinite x = 0
  | otherwise = max (negate limit) (min limit x)

-- | Ten times a second: commands for the robot without a new command of the program. The safety rules own the wheels while
-- a sensor touches something and 0.2 s longer; then the latest velocity of the program holds again (rule R9).
onTick :: Double -> Guard -> ([Action], Guard)
onTick t = withAbsence t (ticked t)

ticked :: Double -> Guard -> ([Action], Guard)
ticked t g
  | not (connected g) || halted g || not (watched g) || not (armed g) = ([], g)
  | safe g, Just (v, w) <- evasiveVelocity (hazards g) = ([driveAt v w], g {ownedUntil = t + holds})
  | isEvading g && t >= ownedUntil g = ([uncurry driveAt (kept g)], g {ownedUntil = 0})
  | isEvading g || kept g == (0, 0) = ([], g)
  | otherwise = ([uncurry driveAt (kept g)], g)

-- | How long the safety rules own the wheels after the last contact, seconds: the timeout of the multiplexer of
-- safe_random_walker_app.
holds :: Double
holds = 0.2

-- | Switches the safety rules. When they are switched off while they own the wheels, the latest velocity of the program
-- holds again at once.
setSafetyRules :: Bool -> Guard -> ([Action], Guard)
setSafetyRules yes g
  | yes || not (isEvading g) = ([], g {safe = yes})
  | otherwise = ([uncurry driveAt (kept g) | connected g && not (halted g) && watched g], g {safe = False, ownedUntil = 0})

-- | Halts the wheels; commands of the program have no effect from now on.
haltWheels :: Guard -> ([Action], Guard)
haltWheels g = ([VelocityCommand (Velocity 0 0)], g {halted = True, kept = (0, 0), ownedUntil = 0})

-- | Another program begins: it starts where the robot is, may drive, and what is pressed is still pressed.
startRun :: Guard -> Guard
startRun g = g {halted = False, watched = True, armed = True, kept = (0, 0), ownedUntil = 0, origin = Nothing, activeAt = Nothing, staleUntil = 0, drivenSince = Nothing}

-- | Whether a robot that is told to drive moves, by its odometry: asked at every tick, it answers when that changes. 'False' after a second in
-- which the program's velocity went to the wheels and the odometry stayed the same.
noticeMotion :: Double -> Guard -> (Maybe Bool, Guard)
noticeMotion t g = case (odometry g, drivenSince g) of
  (Just o, Just (since, before))
    | isDriven && not (before `differsFrom` o) -> if t - since >= motionTimeout && not (toldStill g) then (Just False, g {toldStill = True}) else (Nothing, g)
    | isDriven && toldStill g -> (Just True, g {drivenSince = Just (t, o), toldStill = False})
  (Just o, _) | isDriven -> (Nothing, g {drivenSince = Just (t, o)})
  _ -> (Nothing, g {drivenSince = Nothing})
  where
    isDriven = connected g && not (halted g) && watched g && armed g && not (isEvading g) && isFast (kept g)
    -- Slower ones are hard to tell from a robot that stands: 0.02 m/s and 0.1 rad/s, a choice of ours.
    isFast (v, w) = abs v >= 0.02 || abs w >= 0.1
    -- A tenth of what the slowest of these would do in a second: 2 mm and 0.01 rad.
    differsFrom (Odometry (Position x0 y0) (Orientation a0) _) (Odometry (Position x y) (Orientation a) _) = abs (x - x0) + abs (y - y0) > 0.002 || abs (a - a0) > 0.01

-- | How long a robot may take to move, seconds.
motionTimeout :: Double
motionTimeout = 1

-- | Whether the robot is watched. Unwatched wheels stand; the last command of the program is carried out again afterwards.
setWatched :: Bool -> Guard -> ([Action], Guard)
setWatched yes g
  | watched g == yes = ([], g)
  | yes = ([], g {watched = True})
  | otherwise = ([VelocityCommand (Velocity 0 0) | connected g], g {watched = False, ownedUntil = 0})
