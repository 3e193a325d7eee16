{-# LANGUAGE FlexibleContexts #-}

-- |
-- Module      : Rosy.Motion
-- Description : Ready-made tasks: closed-loop driving and turning, chance, lights, sounds and the pen.
--
-- Ordinary Rosy programs, written with "Rosy.Task" only. A program that defines one of these names uses its own (rule R20).
--
-- > main = simulate $ replicateM_ 4 $ do
-- >   drive 50
-- >   turn 90
--
-- 'drive' and 'turn' read odometry and end when the robot stands within 5 mm or half a degree of the goal. They do not end while
-- something blocks the robot; @race (wait 10) (drive 50)@ gives up.
module Rosy.Motion
  ( -- * Driving
    drive,
    turn,
    driveUntil,
    driveUntilBump,
    driveBack,
    turnBetween,
    goTo,
    curveUntilObstacle,

    -- * Chance
    randomNumber,
    dice,
    eitherOr,

    -- * Lights and sounds
    blink,
    beep,

    -- * The pen
    penDown,
    penUp,
    penColor,
    penWidth,
  )
where

import Data.Typeable (Typeable)
import Rosy.Command
import Rosy.Controller
import Rosy.Geometry
import Rosy.Robot
import Rosy.Sensor
import Rosy.Task
import Rosy.Time
import System.Random (Random, StdGen, randomR)

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

-- | Drive back (0.2 m/s) for so many seconds, and stand still.
driveBack :: Seconds -> Task ()
driveBack time = once (Velocity (-0.2) 0) >> wait time >> once (Velocity 0 0)

-- | Turn by a random angle between these two, in degrees: left is positive.
turnBetween :: Degrees -> Degrees -> Task ()
turnBetween from to = randomNumber from to >>= turn

-- | Drive to a place and stand still within a centimetre of it. The place is in metres from where the program started: ahead of the robot as it stood
-- there, and to its left. The robot turns towards the place and drives straight: it does not go round what stands in the way.
goTo :: Meters -> Meters -> Task ()
goTo ahead left = taskNamed (Name "goTo") (Name "goTo") () (runGoTo (Position ahead left))

runGoTo :: Position -> Pose -> Velocity -> (Velocity, Maybe (Done ()))
runGoTo place (Pose here facing) (Velocity v w)
  | rest < 0.01 = (Velocity 0 0, if abs v < 0.01 && abs w < 0.02 then Just (Done ()) else Nothing)
  | abs deviation > 0.3 = (Velocity 0 (approach 0.15 1.2 1.5 deviation), Nothing)
  | otherwise = (Velocity (approach 0.05 0.3 0.4 rest) (2 * deviation), Nothing)
  where
    Orientation heading = facing
    way = positionToVec place `subVec` positionToVec here
    rest = magnitudeVec way
    deviation = normRadians (angleVec way - heading)

-- | Drive (0.2 m/s) and turn by so many degrees a second (left is positive) until a bumper is pressed or a cliff sensor sees a hole, and stand still.
curveUntilObstacle :: Degrees -> Task ()
curveUntilObstacle turning = do
  task (Velocity 0.2 (degreesToRadians turning)) obstacle
  once (Velocity 0 0)
  where
    obstacle :: Either Bumper Cliff -> Maybe (Done ())
    obstacle (Left (Bumper _ Pressed)) = Just (Done ())
    obstacle (Right (Cliff _ Hole)) = Just (Done ())
    obstacle _ = Nothing

-- | A random number between these two. The same seed of a run gives the same numbers again (rule R13).
randomNumber :: Double -> Double -> Task Double
randomNumber from to = taskNamed (Name "randomNumber") (Name "randomNumber") (draw from to) ()

-- | A random whole number from 1 to this one.
dice :: Int -> Task Int
dice sides = taskNamed (Name "dice") (Name "dice") (draw 1 (max 1 sides)) ()

draw :: Random a => a -> a -> StdGen -> Done a
draw from to gen = Done (fst (randomR (from, to) gen))

-- | One of the two, by chance: each as likely as the other.
eitherOr :: Task a -> Task a -> Task a
eitherOr one other = dice 2 >>= \n -> if n == 1 then one else other

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

-- | Lower the pen: from here on the robot draws where it drives.
penDown :: Task ()
penDown = once PenDown

-- | Raise the pen: the robot drives on without drawing.
penUp :: Task ()
penUp = once PenUp

-- | Draw in this colour from here on.
penColor :: PenColor -> Task ()
penColor = once

-- | Draw this many centimetres wide from here on.
penWidth :: Centimeters -> Task ()
penWidth width = once (PenWidth (centimetersToMeters width))
