-- |
-- Module      : Rosy.Kobuki.Sensing
-- Description : From packets to events and odometry.
--
-- In: the parts of packets, one packet after another. Out: messages of all channels that changed, by the robot's serial table, and
-- odometry: place from the wheels, heading from the gyroscope. Pure; order and signs are kobuki_driver's
-- (event_manager.cpp: update) and kobuki_node's (odometry.cpp), which publish events before the odometry of
-- the same packet.
module Rosy.Kobuki.Sensing
  ( Sensing,
    unsensed,
    resumed,
    sense,
    metresPerTick,
  )
where

import Data.Int (Int16)
import Data.Word (Word16)
import Rosy.Channel (Message)
import Rosy.Kobuki.Feedback
import Rosy.Kobuki.Table (serialTable)
import Rosy.Robot
import Rosy.Robots.SerialCodec

-- | What the packets so far have said.
data Sensing = Sensing
  { -- | the packet before, and the gyroscope's heading in the first one
    before :: !(Maybe (Core, Int16)),
    reported :: !Reported,
    -- | where the robot looked in that first packet, radians
    lookedAt :: !Double,
    atX, atY, heading :: !Double,
    -- | packets in a row that could not be believed
    doubts :: !Int
  }

unsensed :: Sensing
unsensed = Sensing Nothing nothingReported 0 0 0 0 0

-- | After a time without packets: place and heading stay, and what the counters did meanwhile does not count.
resumed :: Sensing -> Sensing
resumed s = s {before = Nothing, lookedAt = heading s}

-- | Metres that a wheel moves per tick of its encoder: 0.035 m radius and 0.00243691687 rad a tick
-- (kobuki_driver, diff_drive.cpp: tick_to_rad).
metresPerTick :: Double
metresPerTick = 0.00243691687 * 0.035

-- | Takes one packet. A checksum of eight bits lets one corrupted packet in 256 pass, so what no robot can do is not
-- believed, unless it goes on: then the base has been somewhere else meanwhile.
sense :: Parts -> Sensing -> ([Message], Sensing)
sense parts s = case coreOf feedback of
  Nothing -> ([], s)
  Just core
    | believable core s -> taken parts core inertia s {doubts = 0}
    | doubts s < patience -> ([], s {doubts = doubts s + 1})
    | possible core -> taken parts core inertia (resumed s) {doubts = 0}
    | otherwise -> ([], s)
  where
    feedback = readFeedback parts
    inertia = inertiaOf feedback

-- | A tenth of a second at 50 Hz.
patience :: Int
patience = 5

-- | Only bits that have a meaning.
possible :: Core -> Bool
possible c = bumpers c < 8 && cliffs c < 8 && buttons c < 8 && wheelDrops c < 4

-- | Also: time went on, by less than a second, and no wheel went faster than it can: 1.4 times the top speed of
-- 0.7 m/s, and a little for jolts.
believable :: Core -> Sensing -> Bool
believable c s = possible c && maybe True (follows . fst) (before s)
  where
    follows old = passed > 0 && passed < 1000 && all (<= 100 + 12 * passed) [turned leftEncoder, turned rightEncoder]
      where
        passed = fromIntegral (timeStamp c - timeStamp old) :: Int
        turned wheel = abs (fromIntegral (fromIntegral (wheel c - wheel old :: Word16) :: Int16)) :: Int

taken :: Parts -> Core -> Maybe Inertia -> Sensing -> ([Message], Sensing)
taken parts core inertia s = (messages ++ [OdometryMessage odometry], s {before = Just (core, firstAngle), reported = now, atX = x, atY = y, heading = theta})
  where
    (messages, now) = changes serialTable parts (reported s)
    firstAngle = maybe (maybe 0 angle inertia) snd (before s)
    -- The difference of 16 bit counters, however often they have wrapped.
    moved new old = fromIntegral (fromIntegral (new - old :: Word16) :: Int16) * metresPerTick
    (dl, dr, dt) = case before s of
      Nothing -> (0, 0, 0)
      Just (old, _) ->
        ( moved (leftEncoder core) (leftEncoder old),
          moved (rightEncoder core) (rightEncoder old),
          fromIntegral (timeStamp core - timeStamp old) / 1000 :: Double
        )
    forward = (dl + dr) / 2
    theta = case inertia of
      Just i -> wrapped (lookedAt s + hundredths (fromIntegral (angle i) - fromIntegral firstAngle))
      Nothing -> wrapped (heading s + (dr - dl) / 0.23)
    -- Half the turn before the step and half after it.
    middle = heading s + wrapped (theta - heading s) / 2
    x = atX s + forward * cos middle
    y = atY s + forward * sin middle
    velocity = Velocity (if dt > 0 then forward / dt else 0) (maybe 0 (hundredths . fromIntegral . angleRate) inertia)
    odometry = Odometry (Position x y) (Orientation theta) velocity

-- | Hundredths of degrees as radians.
hundredths :: Double -> Double
hundredths a = a * pi / 18000

-- | To (-pi, pi].
wrapped :: Double -> Double
wrapped a
  | a > pi = wrapped (a - 2 * pi)
  | a <= negate pi = wrapped (a + 2 * pi)
  | otherwise = a
