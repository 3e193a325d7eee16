{-# LANGUAGE FlexibleContexts #-}

-- |
-- Module      : Rosy.Motion
-- Description : Ready-made tasks: closed-loop driving and turning, lights and sounds.
--
-- Ordinary Rosy programs, written with "Rosy.Task" only. A program that defines one of these names uses its own (rule R20).
--
-- > main = simulate $ replicateM_ 4 $ do
-- >   drive 50
-- >   turn 90
--
-- Driving and turning read odometry and end when the robot stands within 5 mm or half a degree of the goal. They do not end while
-- something blocks the robot; @race (wait 10) (drive 50)@ gives up.
module Rosy.Motion
  ( -- * Driving
    drive,
    turn,
    driveUntil,
    driveUntilBump,

    -- * Lights and sounds
    blink,
    beep,
  )
where

import Data.Typeable (Typeable)
import Rosy.Command
import Rosy.Controller
import Rosy.Geometry
import Rosy.Robot
import Rosy.Sensor
import Rosy.Task

-- | Drive so many centimetres ahead (back if negative), keep the heading, and stand still.
drive :: Centimeters -> Task ()
drive distance = taskNamed (Name "drive") (Name "drive") startDrive (runDrive (centimetersToMeters distance))

startDrive :: Pose -> Memory Pose
startDrive = Memory

runDrive :: Meters -> Memory Pose -> Pose -> Velocity -> (Velocity, Maybe (Done ()))
runDrive goal (Memory (Pose start heading)) (Pose here facing) (Velocity v _)
  | abs rest > 0.003 = (Velocity (approach 0.05 0.3 0.4 rest) steer, Nothing)
  | otherwise = (Velocity 0 0, if abs v < 0.01 then Just (Done ()) else Nothing)
  where
    Orientation course = heading
    Orientation deviation = normOrientation (heading - facing)
    (x, y) = positionToVec here `subVec` positionToVec start
    rest = goal - (x * cos course + y * sin course)
    steer = max (-0.5) (min 0.5 (2 * deviation))

-- | Turn by so many degrees on the spot, to the left (to the right if negative), and stand still.
turn :: Degrees -> Task ()
turn angle = taskNamed (Name "turn") (Name "turn") (startTurn (degreesToRadians angle)) runTurn

-- | The angle that is still to turn (radians), and the last heading. It counts whole turns, which a heading does not.
startTurn :: Radians -> Orientation -> Memory (Radians, Orientation)
startTurn angle heading = Memory (angle, heading)

runTurn :: Memory (Radians, Orientation) -> Orientation -> Velocity -> (Memory (Radians, Orientation), Velocity, Maybe (Done ()))
runTurn (Memory (before, last')) heading (Velocity _ w)
  | abs rest > 0.005 = (remaining, Velocity 0 (approach 0.15 1.2 1.5 rest), Nothing)
  | otherwise = (remaining, Velocity 0 0, if abs w < 0.02 then Just (Done ()) else Nothing)
  where
    Orientation turned = normOrientation (heading - last')
    rest = before - turned
    remaining = Memory (rest, heading)

-- | A speed towards a goal that is so far away: between a slowest and a fastest speed, such that a constant deceleration ends at the goal.
-- Takes slowest, fastest, deceleration and distance, in metres or radians and seconds.
approach :: Double -> Double -> Double -> Double -> Double
approach slowest fastest deceleration rest = signum rest * max slowest (min fastest (sqrt (2 * deceleration * abs rest)))

-- | Drive ahead (0.2 m/s) until the controller gives 'Done', then stand still.
--
-- > driveUntil (\(Button _ _) -> Done ())
driveUntil :: (Controller ctrl, Typeable end, Ends end ctrl) => ctrl -> Task end
driveUntil ctrl = do
  result <- task (Velocity 0.2 0) ctrl
  once (Velocity 0 0)
  pure result

-- | Drive ahead until a bumper is pressed, and stand still. Its result is the side of the bumper.
driveUntilBump :: Task BumperSide
driveUntilBump = driveUntil bumped
  where
    bumped :: Bumper -> Maybe (Done BumperSide)
    bumped (Bumper side Pressed) = Just (Done side)
    bumped _ = Nothing

-- | Half a second of light in the first LED, half a second without.
blink :: LedColor -> Task ()
blink color = do
  once (Led1 color)
  wait 0.5
  once (Led1 Black)
  wait 0.5

-- | A short sound.
beep :: Task ()
beep = once ButtonSound >> wait 0.5
